using System.Collections.Generic;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Scenelang
{
    /// <summary>
    /// Compares every object with the bounds that were written beside it: a mesh that was imported mirrored, scaled or
    /// not at all is found when the scene is first opened. In batch mode: -executeMethod Scenelang.SelfTest.Run
    /// </summary>
    public static class SelfTest
    {
        const float Tolerance = 0.002f;
        const string Done = "Scenelang.SelfTest.Done";

        [InitializeOnLoadMethod]
        static void Watch()
        {
            EditorSceneManager.sceneOpened += (scene, mode) =>
            {
                if (SessionState.GetBool(Done + scene.path, false)) return;
                SessionState.SetBool(Done + scene.path, true);
                Report(scene);
            };
        }

        [MenuItem("Tools/Scenelang/Self Test")]
        static void Check()
        {
            Report(SceneManager.GetActiveScene());
        }

        /// <summary>For the command line: checks all scenes and ends the editor with 0, or with 1 if one fails.</summary>
        public static void Run()
        {
            int failures = 0;
            foreach (string guid in AssetDatabase.FindAssets("t:Scene", new[] { "Assets/Scenes" }))
            {
                string path = AssetDatabase.GUIDToAssetPath(guid);
                failures += Report(EditorSceneManager.OpenScene(path, OpenSceneMode.Single));
            }
            EditorApplication.Exit(failures == 0 ? 0 : 1);
        }

        static int Report(Scene scene)
        {
            int objects = 0;
            int failures = 0;
            foreach (GameObject root in scene.GetRootGameObjects())
            {
                foreach (ScenelangObject item in root.GetComponentsInChildren<ScenelangObject>(true))
                {
                    objects++;
                    string wrong = Fault(item);
                    if (wrong == null) continue;
                    failures++;
                    Debug.LogError("scenelang: " + item.id + ": " + wrong, item);
                }
            }
            if (objects > 0 && failures == 0)
            {
                Debug.Log("scenelang: all " + objects + " objects of " + scene.name + " are where the layout places them");
            }
            return failures;
        }

        static string Fault(ScenelangObject item)
        {
            MeshFilter filter = item.GetComponent<MeshFilter>();
            if (filter == null || filter.sharedMesh == null) return "its mesh is missing";
            MeshRenderer renderer = item.GetComponent<MeshRenderer>();
            int surfaces = renderer == null ? 0 : renderer.sharedMaterials.Length;
            if (filter.sharedMesh.subMeshCount != surfaces)
            {
                return "it has " + surfaces + " materials for " + filter.sharedMesh.subMeshCount + " submeshes";
            }
            Vector3 min = Vector3.positiveInfinity;
            Vector3 max = Vector3.negativeInfinity;
            // Doors and drawers have meshes of their own.
            foreach (MeshFilter part in item.GetComponentsInChildren<MeshFilter>(true))
            {
                if (part.GetComponentInParent<ScenelangObject>() != item) continue;
                if (part.sharedMesh == null) return "the mesh of " + part.name + " is missing";
                List<Vector3> vertices = new List<Vector3>();
                part.sharedMesh.GetVertices(vertices);
                foreach (Vector3 vertex in vertices)
                {
                    Vector3 world = part.transform.TransformPoint(vertex);
                    min = Vector3.Min(min, world);
                    max = Vector3.Max(max, world);
                }
            }
            foreach (Joint joint in item.GetComponentsInChildren<Joint>(true))
            {
                if (joint.connectedBody == null) return "the joint of " + joint.name + " is connected to nothing";
            }
            if (Far(min, item.boundsMin) || Far(max, item.boundsMax))
            {
                return "it reaches from " + min + " to " + max + ", the layout says from " + item.boundsMin + " to " + item.boundsMax;
            }
            return null;
        }

        static bool Far(Vector3 a, Vector3 b)
        {
            Vector3 d = a - b;
            return Mathf.Abs(d.x) > Tolerance || Mathf.Abs(d.y) > Tolerance || Mathf.Abs(d.z) > Tolerance;
        }
    }
}
