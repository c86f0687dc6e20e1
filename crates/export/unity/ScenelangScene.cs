using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.AI;

namespace Scenelang
{
    /// <summary>
    /// The program that a scene was made from, its layout, and the report on it; and what a script asks of the scene.
    /// </summary>
    [DisallowMultipleComponent]
    public sealed class ScenelangScene : MonoBehaviour
    {
        /// <summary>The program.</summary>
        [Tooltip("The program.")]
        public TextAsset spec;

        /// <summary>Where the program's objects were placed.</summary>
        [Tooltip("Where the program's objects were placed.")]
        public TextAsset layout;

        /// <summary>Every constraint with its margin.</summary>
        [Tooltip("Every constraint with its margin.")]
        public TextAsset report;

        /// <summary>SHA-256 of the layout as it was exported.</summary>
        [Tooltip("Of the layout as it was exported.")]
        public string layoutSha256;

        /// <summary>The version of scenelang that wrote this scene.</summary>
        [Tooltip("The version of scenelang that wrote this scene.")]
        public string version;

        /// <summary>The rows of the report, and which objects may overlap, in the form that the scripts read.</summary>
        [Tooltip("The rows of the report, and which objects may overlap, for scripts.")]
        public TextAsset rows;

        // An editor that reloads scripts would otherwise make an empty one of none.
        [NonSerialized]
        ScenelangReport read;

        ScenelangReport Report
        {
            get
            {
                if (read == null && rows != null) read = JsonUtility.FromJson<ScenelangReport>(rows.text);
                return read ?? new ScenelangReport { constraints = new ScenelangConstraint[0], overlaps = new ScenelangOverlap[0] };
            }
        }

        /// <summary>The rows of the report.</summary>
        public ScenelangConstraint[] Constraints
        {
            get { return Report.constraints; }
        }

        // What may overlap is not pushed apart.
        void Awake()
        {
            foreach (ScenelangOverlap pair in Report.overlaps)
            {
                ScenelangObject a = Find(pair.a);
                ScenelangObject b = Find(pair.b);
                if (a != null && b != null) ScenelangObject.Pass(a, b);
            }
        }

        /// <summary>All objects of the program, in its order.</summary>
        public ScenelangObject[] Objects
        {
            get { return GetComponentsInChildren<ScenelangObject>(true); }
        }

        /// <summary>The object of this name: <c>lamp</c>, <c>chair[0]</c>; null where there is none.</summary>
        public ScenelangObject Find(string id)
        {
            return Array.Find(Objects, item => item.id == id);
        }

        /// <summary>The objects of a category; case does not count.</summary>
        public ScenelangObject[] FindByCategory(string category)
        {
            return Array.FindAll(
                Objects, item => string.Equals(item.category, category, StringComparison.OrdinalIgnoreCase));
        }

        /// <summary>
        /// The objects whose declaration stands for a sentence with these words, and those that are in a constraint which does;
        /// case does not count.
        /// </summary>
        public ScenelangObject[] FindByRequirement(string words)
        {
            HashSet<string> asked = new HashSet<string>();
            foreach (ScenelangConstraint row in FindConstraints(words)) asked.Add(row.id);
            return Array.FindAll(
                Objects, item => item.Requires(words) || Array.Exists(item.constraints, row => asked.Contains(row)));
        }

        /// <summary>The constraints that stand for a sentence with these words; case does not count.</summary>
        public ScenelangConstraint[] FindConstraints(string words)
        {
            return Array.FindAll(Constraints, row => row.Requires(words));
        }

        /// <summary>The constraints that an object is in.</summary>
        public ScenelangConstraint[] ConstraintsOf(ScenelangObject item)
        {
            return Array.FindAll(Constraints, row => Array.IndexOf(item.constraints, row.id) >= 0);
        }

        /// <summary>The objects that are in a constraint.</summary>
        public ScenelangObject[] ObjectsOf(ScenelangConstraint row)
        {
            return Array.FindAll(Objects, item => Array.IndexOf(item.constraints, row.id) >= 0);
        }

        /// <summary>The part of this name: <c>wardrobe/door</c>; null where there is none.</summary>
        public ScenelangJoint FindJoint(string id)
        {
            return Array.Find(GetComponentsInChildren<ScenelangJoint>(true), joint => joint.id == id);
        }

        /// <summary>Opens a part: 0 is closed, 1 is as far as it goes. False where there is no such part.</summary>
        public bool Open(string joint, float fraction = 1f)
        {
            ScenelangJoint part = FindJoint(joint);
            if (part == null) return false;
            part.Open(fraction);
            return true;
        }

        /// <summary>Closes a part. False where there is no such part.</summary>
        public bool Close(string joint)
        {
            return Open(joint, 0f);
        }

        /// <summary>
        /// The distance between the solids of two objects as they stand now, in metres: 0 where they touch, infinite where one
        /// has no solid.
        /// </summary>
        public static float Distance(ScenelangObject a, ScenelangObject b)
        {
            Physics.SyncTransforms();
            Collider[] others = b.Solids;
            float least = float.PositiveInfinity;
            foreach (Collider part in a.Solids)
            {
                foreach (Collider other in others) least = Mathf.Min(least, Between(part, other));
            }
            return least;
        }

        // Projecting by turns onto two convex bodies leads to the points in which they are nearest.
        static float Between(Collider a, Collider b)
        {
            const int Turns = 100;
            const float Same = 1e-6f;
            Vector3 here = a.bounds.center;
            float before = float.PositiveInfinity;
            for (int turn = 0; turn < Turns; turn++)
            {
                Vector3 there = b.ClosestPoint(here);
                here = a.ClosestPoint(there);
                float now = Vector3.Distance(here, there);
                if (before - now < Same) return now;
                before = now;
            }
            return before;
        }

        /// <summary>
        /// The shortest way on foot from beside one object to beside another, on the mesh that <see cref="ScenelangNavMesh"/>
        /// bakes. False where no way leads all along; the path is then empty.
        /// </summary>
        public bool FreePath(ScenelangObject from, ScenelangObject to, NavMeshPath path)
        {
            ScenelangNavMesh mesh = GetComponent<ScenelangNavMesh>();
            path.ClearCorners();
            if (mesh == null) return false;
            List<Vector3> starts = mesh.Beside(from);
            List<Vector3> ends = mesh.Beside(to);
            NavMeshPath tried = new NavMeshPath();
            float shortest = float.PositiveInfinity;
            Vector3 start = Vector3.zero;
            Vector3 end = Vector3.zero;
            foreach (Vector3 a in starts)
            {
                foreach (Vector3 b in ends)
                {
                    if (!NavMesh.CalculatePath(a, b, NavMesh.AllAreas, tried)) continue;
                    float length = Length(tried);
                    if (tried.status != NavMeshPathStatus.PathComplete || length >= shortest) continue;
                    shortest = length;
                    start = a;
                    end = b;
                }
            }
            return shortest < float.PositiveInfinity && NavMesh.CalculatePath(start, end, NavMesh.AllAreas, path);
        }

        /// <summary>The length of a path, in metres.</summary>
        public static float Length(NavMeshPath path)
        {
            float length = 0f;
            Vector3[] corners = path.corners;
            for (int i = 1; i < corners.Length; i++) length += Vector3.Distance(corners[i - 1], corners[i]);
            return length;
        }
    }
}
