using UnityEngine;

namespace Scenelang
{
    /// <summary>What the program says of an object.</summary>
    [DisallowMultipleComponent]
    public sealed class ScenelangObject : MonoBehaviour
    {
        /// <summary>Its name in the program.</summary>
        [Tooltip("Its name in the program.")]
        public string id;

        /// <summary>What it is: <c>desk</c>. Empty where the program does not say.</summary>
        public string category;

        /// <summary>The statement that declares it.</summary>
        [Tooltip("The statement that declares it.")]
        public string declaration;

        /// <summary>Sentences that its declaration stands for.</summary>
        [Tooltip("Sentences that its declaration stands for.")]
        public string[] requirements;

        /// <summary>Rows of the report that speak of it, by id.</summary>
        [Tooltip("Rows of the report that speak of it.")]
        public string[] constraints;

        /// <summary>Least corner of what is seen of it, in world axes, where the layout places it.</summary>
        [Tooltip("Least corner of what is seen of it, in world axes, where the layout places it.")]
        public Vector3 boundsMin;

        /// <summary>Greatest corner of what is seen of it, in world axes, where the layout places it.</summary>
        [Tooltip("Greatest corner of what is seen of it, in world axes, where the layout places it.")]
        public Vector3 boundsMax;

        /// <summary>Whether a sentence that its declaration stands for contains these words; case does not count.</summary>
        public bool Requires(string words)
        {
            return ScenelangConstraint.Contain(requirements, words);
        }

        /// <summary>Its doors, drawers and lids.</summary>
        public ScenelangJoint[] Joints
        {
            get { return GetComponentsInChildren<ScenelangJoint>(true); }
        }

        /// <summary>Its solid parts, those of doors and drawers among them.</summary>
        public Collider[] Solids
        {
            get { return System.Array.FindAll(GetComponentsInChildren<Collider>(), part => !part.isTrigger); }
        }

        /// <summary>The part of this name: <c>door</c>, <c>drawer 2</c>; null where it has none.</summary>
        public ScenelangJoint FindJoint(string part)
        {
            return System.Array.Find(Joints, joint => joint.id == id + "/" + part);
        }

        // Doors and drawers that are closed touch each other, and the engine would push them apart.
        void Awake()
        {
            ScenelangJoint[] joints = Joints;
            for (int i = 0; i < joints.Length; i++)
            {
                for (int j = 0; j < i; j++) Pass(joints[i], joints[j]);
            }
        }

        internal static void Pass(Component a, Component b)
        {
            foreach (Collider part in a.GetComponentsInChildren<Collider>())
            {
                foreach (Collider other in b.GetComponentsInChildren<Collider>()) Physics.IgnoreCollision(part, other);
            }
        }
    }
}
