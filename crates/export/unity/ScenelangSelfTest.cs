using System.Collections.Generic;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Scenelang
{
    /// <summary>
    /// Compares every object with the bounds that were written beside it: a mesh that was imported mirrored, scaled or
    /// not at all is found when the scene is first opened. From the menu and from the command line every door, drawer and lid
    /// is also driven to its limits by the physics engine, and where it ends is compared with its range. In batch mode:
    /// -executeMethod Scenelang.SelfTest.Run
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
                Report(scene, false);
            };
        }

        [MenuItem("Tools/Scenelang/Self Test")]
        static void Check()
        {
            Report(SceneManager.GetActiveScene(), true);
        }

        /// <summary>For the command line: checks all scenes and ends the editor with 0, or with 1 if one fails.</summary>
        public static void Run()
        {
            int failures = 0;
            foreach (string guid in AssetDatabase.FindAssets("t:Scene", new[] { "Assets/Scenes" }))
            {
                string path = AssetDatabase.GUIDToAssetPath(guid);
                failures += Report(EditorSceneManager.OpenScene(path, OpenSceneMode.Single), true);
            }
            EditorApplication.Exit(failures == 0 ? 0 : 1);
        }

        static int Report(Scene scene, bool drive)
        {
            int objects = 0;
            int failures = 0;
            List<ScenelangJoint> joints = new List<ScenelangJoint>();
            foreach (GameObject root in scene.GetRootGameObjects())
            {
                joints.AddRange(root.GetComponentsInChildren<ScenelangJoint>());
                foreach (ScenelangObject item in root.GetComponentsInChildren<ScenelangObject>(true))
                {
                    // One of the prefabs that somebody has put there: the layout does not have it.
                    if (string.IsNullOrEmpty(item.id)) continue;
                    objects++;
                    string wrong = Fault(item);
                    if (wrong == null) continue;
                    failures++;
                    Debug.LogError("scenelang: " + item.id + ": " + wrong, item);
                }
            }
            foreach (ScenelangJoint joint in joints)
            {
                string wrong = ScenelangJointTest.Unconnected(joint);
                if (wrong == null) continue;
                failures++;
                Debug.LogError("scenelang: " + joint.id + ": " + wrong, joint);
            }
            if (drive && failures == 0) failures += ScenelangJointTest.Drive(scene, joints);
            if (objects > 0 && failures == 0)
            {
                string driven = drive && joints.Count > 0 ? ", and all " + joints.Count + " joints reach their limits" : "";
                Debug.Log("scenelang: all " + objects + " objects of " + scene.name + " are where the layout places them" + driven);
            }
            return failures;
        }

        static string Fault(ScenelangObject item)
        {
            Vector3 min = Vector3.positiveInfinity;
            Vector3 max = Vector3.negativeInfinity;
            // Doors and drawers have meshes of their own.
            MeshFilter[] parts = item.GetComponentsInChildren<MeshFilter>(true);
            if (parts.Length == 0) return "its mesh is missing";
            foreach (MeshFilter part in parts)
            {
                if (part.GetComponentInParent<ScenelangObject>(true) != item) continue;
                string name = part.transform == item.transform ? "it" : part.name;
                if (part.sharedMesh == null) return "the mesh of " + name + " is missing";
                MeshRenderer renderer = part.GetComponent<MeshRenderer>();
                int surfaces = renderer == null ? 0 : renderer.sharedMaterials.Length;
                if (part.sharedMesh.subMeshCount != surfaces)
                {
                    return name + " has " + surfaces + " materials for " + part.sharedMesh.subMeshCount + " submeshes";
                }
                // Where it is when everything is closed.
                Transform frame = part.GetComponent<ScenelangJoint>() == null ? part.transform : part.transform.parent;
                List<Vector3> vertices = new List<Vector3>();
                part.sharedMesh.GetVertices(vertices);
                foreach (Vector3 vertex in vertices)
                {
                    Vector3 world = frame.TransformPoint(vertex);
                    min = Vector3.Min(min, world);
                    max = Vector3.Max(max, world);
                }
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
