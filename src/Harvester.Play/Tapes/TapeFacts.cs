namespace Harvester.Play.Tapes;

/// <summary>The names of facts.</summary>
public static class TapeFacts
{
    /// <summary>Version of the mod.</summary>
    public const string Mod = "mod";

    /// <summary>Version of the scripting API.</summary>
    public const string Api = "api";

    /// <summary>File name of the game's program: which edition it is.</summary>
    public const string Program = "program";

    /// <summary>File version of the game's program; absent if it cannot be read.</summary>
    public const string Build = "build";

    /// <summary>The settings, without paths and names.</summary>
    public const string Settings = "settings";

    /// <summary>The table of the faces of signs that the mod comes with.</summary>
    public const string Faces = "faces";

    /// <summary>The player's own table of faces.</summary>
    public const string MeasuredFaces = "measuredFaces";

    /// <summary>The table of materials.</summary>
    public const string Materials = "materials";

    /// <summary>The rig.</summary>
    public const string Rig = "rig";
}
