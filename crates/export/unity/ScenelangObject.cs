using UnityEngine;

namespace Scenelang
{
    /// <summary>What the program says of an object.</summary>
    [DisallowMultipleComponent]
    public sealed class ScenelangObject : MonoBehaviour
    {
        [Tooltip("Its name in the program.")]
        public string id;

        public string category;

        [Tooltip("The statement that declares it.")]
        public string declaration;

        [Tooltip("Rows of the report that speak of it.")]
        public string[] constraints;

        [Tooltip("Least corner of what is seen of it, in world axes, where the layout places it.")]
        public Vector3 boundsMin;

        [Tooltip("Greatest corner of what is seen of it, in world axes, where the layout places it.")]
        public Vector3 boundsMax;
    }
}
