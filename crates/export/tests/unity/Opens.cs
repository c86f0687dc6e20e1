// Opens parts of known joints, and prints where a point of them is then.

using System;
using System.Globalization;
using Scenelang;
using UnityEngine;

static class Opens
{
    static readonly CultureInfo Plain = CultureInfo.InvariantCulture;

    // A line of standard input: motion, axis, pivot, min, max, point, fraction. A line of output: opening, point.
    static void Main()
    {
        for (string line = Console.ReadLine(); line != null; line = Console.ReadLine())
        {
            float[] n = Array.ConvertAll(line.Split(' '), word => float.Parse(word, Plain));
            ScenelangJoint joint = new ScenelangJoint();
            joint.motion = (ScenelangMotion)(int)n[0];
            joint.axis = new Vector3(n[1], n[2], n[3]);
            joint.pivot = new Vector3(n[4], n[5], n[6]);
            joint.min = n[7];
            joint.max = n[8];
            joint.Open(n[12]);
            Transform pose = joint.transform;
            Vector3 at = pose.localPosition + pose.localRotation * new Vector3(n[9], n[10], n[11]);
            Console.WriteLine(string.Format(Plain, "{0:R} {1:R} {2:R} {3:R}", joint.Opening, at.x, at.y, at.z));
        }
    }
}
