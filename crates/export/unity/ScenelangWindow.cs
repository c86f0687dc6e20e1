using System;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Scenelang
{
    /// <summary>
    /// Lists the constraints of the open scene with their verdicts, as the report says them of the exported layout. A click on
    /// one selects its objects.
    /// </summary>
    public sealed class ScenelangWindow : EditorWindow
    {
        const float Mark = 70f;
        const float Amount = 90f;

        string words = "";
        bool violatedOnly;
        Vector2 scroll;
        string chosen = "";

        [MenuItem("Tools/Scenelang/Constraints")]
        static void Open()
        {
            GetWindow<ScenelangWindow>("Constraints");
        }

        void OnHierarchyChange()
        {
            Repaint();
        }

        void OnGUI()
        {
            ScenelangScene scene = Current();
            if (scene == null)
            {
                EditorGUILayout.HelpBox("The open scene was not written by scenelang.", MessageType.Info);
                return;
            }
            EditorGUILayout.BeginHorizontal(EditorStyles.toolbar);
            words = EditorGUILayout.TextField(words, EditorStyles.toolbarSearchField);
            violatedOnly = GUILayout.Toggle(violatedOnly, "Violated", EditorStyles.toolbarButton, GUILayout.Width(Mark));
            EditorGUILayout.EndHorizontal();
            EditorGUILayout.LabelField(Summary(scene));
            scroll = EditorGUILayout.BeginScrollView(scroll);
            foreach (ScenelangConstraint row in scene.Constraints)
            {
                if (violatedOnly && row.verdict != ScenelangVerdict.Violated) continue;
                if (words == "" || Mentions(row)) Show(scene, row);
            }
            EditorGUILayout.EndScrollView();
        }

        static ScenelangScene Current()
        {
            foreach (GameObject root in SceneManager.GetActiveScene().GetRootGameObjects())
            {
                ScenelangScene found = root.GetComponentInChildren<ScenelangScene>(true);
                if (found != null) return found;
            }
            return null;
        }

        static string Summary(ScenelangScene scene)
        {
            int[] counts = new int[3];
            foreach (ScenelangConstraint row in scene.Constraints) counts[(int)row.verdict]++;
            string text = counts[(int)ScenelangVerdict.Holds] + " hold, " + counts[(int)ScenelangVerdict.Violated] + " are violated";
            int open = counts[(int)ScenelangVerdict.NotJudged];
            return open == 0 ? text : text + ", " + open + " could not be checked";
        }

        bool Mentions(ScenelangConstraint row)
        {
            return Has(row.id) || Has(row.text) || Array.Exists(row.objects, Has) || Array.Exists(row.requirements, Has);
        }

        bool Has(string text)
        {
            return text.IndexOf(words, StringComparison.OrdinalIgnoreCase) >= 0;
        }

        void Show(ScenelangScene scene, ScenelangConstraint row)
        {
            Color before = GUI.color;
            GUI.color = Tint(row);
            EditorGUILayout.BeginHorizontal();
            GUILayout.Label(Word(row), GUILayout.Width(Mark));
            GUI.color = before;
            string sentences = string.Join("\n", row.requirements);
            string tip = sentences == "" ? row.message : row.message + "\n" + sentences;
            GUIContent label = new GUIContent(row.text, tip);
            if (GUILayout.Button(label, row.id == chosen ? EditorStyles.boldLabel : EditorStyles.label)) Select(scene, row);
            GUILayout.Label(row.margin + " " + row.unit, GUILayout.Width(Amount));
            EditorGUILayout.EndHorizontal();
        }

        static string Word(ScenelangConstraint row)
        {
            switch (row.verdict)
            {
                case ScenelangVerdict.Holds: return "holds";
                case ScenelangVerdict.Violated: return row.IsHard ? "violated" : "not met";
                default: return "not checked";
            }
        }

        static Color Tint(ScenelangConstraint row)
        {
            if (row.verdict == ScenelangVerdict.Holds) return Color.green;
            return row.verdict == ScenelangVerdict.Violated && row.IsHard ? Color.red : Color.yellow;
        }

        void Select(ScenelangScene scene, ScenelangConstraint row)
        {
            chosen = row.id;
            Selection.objects = Array.ConvertAll(scene.ObjectsOf(row), item => (UnityEngine.Object)item.gameObject);
            if (SceneView.lastActiveSceneView != null) SceneView.lastActiveSceneView.FrameSelected();
        }
    }
}
