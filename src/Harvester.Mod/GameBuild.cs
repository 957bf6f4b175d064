using System;
using GTA;

namespace Harvester.Mod;

/// <summary>What this build of the game and this version of the API cannot do together, in words for the player.</summary>
internal static class GameBuild
{
    // 1.0.3179, as ScriptHookV counts builds; 3.6.0 has no name for it.
    private const GameVersion LastOfRelease = (GameVersion)86;

    // Nightlies know newer builds from this one on; those before 3.7 count in the last part.
    private static readonly Version FirstForNewerBuilds = new(3, 6, 0, 89);

    /// <summary>Why no camera can be mounted; null when one can. An unknown native would end the game.</summary>
    public static string? MountProblem => Game.Version is >= 0 and < GameVersion.v1_0_2189_0_Steam
        ? "This build of the game is older than 1.0.2189 and cannot attach a camera rigidly. Update the game."
        : null;

    /// <summary>Why what is near cannot be listed; null when it can. The API reads it from memory, and in a build that it does not know that may end the game.</summary>
    public static string? ListProblem => Game.Version > LastOfRelease && typeof(Script).Assembly.GetName().Version < FirstForNewerBuilds
        ? "This build of the game is newer than ScriptHookVDotNet 3.6.0 knows. Install the latest nightly of ScriptHookVDotNet."
        : null;
}
