using UnityEngine;

namespace Scenelang
{
    /// <summary>The program that a scene was made from, its layout, and the report on it.</summary>
    [DisallowMultipleComponent]
    public sealed class ScenelangScene : MonoBehaviour
    {
        [Tooltip("The program.")]
        public TextAsset spec;

        [Tooltip("Where the program's objects were placed.")]
        public TextAsset layout;

        [Tooltip("Every constraint with its margin.")]
        public TextAsset report;

        [Tooltip("Of the layout as it was exported.")]
        public string layoutSha256;

        [Tooltip("The version of scenelang that wrote this scene.")]
        public string version;
    }
}
