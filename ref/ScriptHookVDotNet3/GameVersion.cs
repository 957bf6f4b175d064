namespace GTA;

/// <summary>The game's builds, in order. Builds newer than the API go on counting without a name.</summary>
public enum GameVersion
{
    /// <summary>A build that ScriptHookV does not know.</summary>
    Unknown = -1,

    /// <summary>The first build with natives to attach a camera rigidly.</summary>
    v1_0_2189_0_Steam = 63,
}
