using System;

namespace Scenelang
{
    /// <summary>What the verifier found of a constraint.</summary>
    public enum ScenelangVerdict
    {
        /// <summary>It could not be judged.</summary>
        NotJudged,

        /// <summary>It holds.</summary>
        Holds,

        /// <summary>It does not hold.</summary>
        Violated
    }

    /// <summary>A row of the report: a constraint, and how well the exported layout satisfied it.</summary>
    [Serializable]
    public sealed class ScenelangConstraint
    {
        /// <summary>Where it is stated, or which rule it is: <c>room.scene:12:1</c>, <c>P-COLLIDE:a:b</c>.</summary>
        public string id;

        /// <summary><c>assert</c>, <c>prefer</c>, <c>pin</c>, or the name of a rule.</summary>
        public string kind;

        /// <summary>The constraint as the program states it.</summary>
        public string text;

        /// <summary>What was measured.</summary>
        public string message;

        /// <summary>Whether the exported layout satisfies it.</summary>
        public ScenelangVerdict verdict;

        /// <summary>By how much it holds; negative where it is violated.</summary>
        public float margin;

        /// <summary>The unit of the margin; empty where it has none.</summary>
        public string unit;

        /// <summary>Sentences of the request that it stands for.</summary>
        public string[] requirements;

        /// <summary>Names of the objects that it is about.</summary>
        public string[] objects;

        /// <summary>Whether it must hold; a preference may be violated.</summary>
        public bool IsHard
        {
            get { return kind != "prefer"; }
        }

        /// <summary>Whether a sentence that it stands for contains these words; case does not count.</summary>
        public bool Requires(string words)
        {
            return Contain(requirements, words);
        }

        internal static bool Contain(string[] sentences, string words)
        {
            return sentences != null
                && Array.Exists(sentences, said => said.IndexOf(words, StringComparison.OrdinalIgnoreCase) >= 0);
        }
    }

    /// <summary>Two objects that may share space by permission of the program.</summary>
    [Serializable]
    public sealed class ScenelangOverlap
    {
        /// <summary>The name of one.</summary>
        public string a;

        /// <summary>The name of the other.</summary>
        public string b;
    }

    /// <summary>What the project knows of the constraints.</summary>
    [Serializable]
    public sealed class ScenelangReport
    {
        /// <summary>The rows of the report, in its order.</summary>
        public ScenelangConstraint[] constraints;

        /// <summary>Objects that may overlap, and are so near each other that they might.</summary>
        public ScenelangOverlap[] overlaps;
    }
}
