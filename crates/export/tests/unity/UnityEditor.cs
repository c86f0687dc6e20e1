// As much of Unity's API for editors as the scripts of an exported project use, without any behaviour: the compiler checks the scripts
// against it. What is here has the names and signatures of Unity's manual for 2022.3 and 6000.0.

using System;

namespace UnityEditor
{
    using UnityEngine;

    public enum MessageType { None, Info, Warning, Error }

    public class EditorWindow : ScriptableObject
    {
        public void Repaint() { }
        public static T GetWindow<T>(string title) where T : EditorWindow { return null; }
    }

    public class SceneView : EditorWindow
    {
        public static SceneView lastActiveSceneView { get { return null; } }
        public bool FrameSelected() { return false; }
    }

    public static class Selection { public static Object[] objects { get; set; } }
    public static class EditorApplication { public static void Exit(int returnValue) { } }

    public static class SessionState
    {
        public static bool GetBool(string key, bool defaultValue) { return defaultValue; }
        public static void SetBool(string key, bool value) { }
    }

    public static class AssetDatabase
    {
        public static string[] FindAssets(string filter, string[] searchInFolders) { return null; }
        public static string GUIDToAssetPath(string guid) { return null; }
    }

    public static class EditorStyles
    {
        public static GUIStyle label { get { return null; } }
        public static GUIStyle boldLabel { get { return null; } }
        public static GUIStyle toolbar { get { return null; } }
        public static GUIStyle toolbarButton { get { return null; } }
        public static GUIStyle toolbarSearchField { get { return null; } }
    }

    public static class EditorGUILayout
    {
        public static void HelpBox(string message, MessageType type) { }
        public static Rect BeginHorizontal(params GUILayoutOption[] options) { return default(Rect); }
        public static Rect BeginHorizontal(GUIStyle style, params GUILayoutOption[] options) { return default(Rect); }
        public static void EndHorizontal() { }
        public static string TextField(string text, GUIStyle style, params GUILayoutOption[] options) { return text; }
        public static void LabelField(string label, params GUILayoutOption[] options) { }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options) { return scrollPosition; }
        public static void EndScrollView() { }
    }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class InitializeOnLoadMethodAttribute : Attribute { }

    [AttributeUsage(AttributeTargets.Method)]
    public sealed class MenuItem : Attribute { public MenuItem(string itemName) { } }
}

namespace UnityEditor.SceneManagement
{
    using UnityEngine.SceneManagement;

    public enum OpenSceneMode { Single, Additive }

    public static class EditorSceneManager
    {
        public delegate void SceneOpenedCallback(Scene scene, OpenSceneMode mode);
        public static event SceneOpenedCallback sceneOpened { add { } remove { } }
        public static Scene OpenScene(string scenePath, OpenSceneMode mode) { return default(Scene); }
    }
}
