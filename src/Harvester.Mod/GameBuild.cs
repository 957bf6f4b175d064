using System.ComponentModel;
using System.Diagnostics;
using GTA;

namespace Harvester.Mod;

/// <summary>
/// The running game: its edition and build, and what it cannot do with the installed scripting API. Both come from the game's program file,
/// because the API's own enumeration of builds lacks new ones and is deprecated.
/// </summary>
/// <param name="program">File name of the game's program.</param>
/// <param name="fileVersion">File version of the program; null if it cannot be read.</param>
/// <param name="api">Version of the scripting API; null for the installed one.</param>
internal sealed class GameBuild(string program, Version? fileVersion, Version? api = null)
{
    private const string EnhancedProgram = "GTA5_Enhanced.exe";

    /// <summary>The first Legacy build with a native that attaches a camera rigidly. Every Enhanced build has it.</summary>
    private static readonly Version FirstWithRigidCameras = new(1, 0, 2189);

    /// <summary>The first Legacy build whose memory release 3.6.0 of the API cannot read.</summary>
    private static readonly Version FirstUnknownToRelease = new(1, 0, 3258);

    /// <summary>The first version of the API that reads the memory of newer builds. Nightlies of 3.6 count in the last part.</summary>
    private static readonly Version FirstApiForNewerBuilds = new(3, 6, 0, 89);

    /// <summary>The assembly version of the installed API, not of the one the mod was compiled against.</summary>
    public Version Api { get; } = api ?? typeof(Script).Assembly.GetName().Version!;

    /// <summary>File name of the game's program.</summary>
    public string Program => program;

    /// <summary>File version of the game's program; null if it cannot be read.</summary>
    public Version? FileVersion => fileVersion;

    /// <summary>Legacy or Enhanced.</summary>
    public string Edition => IsEnhanced ? "Enhanced" : "Legacy";

    /// <summary>File version of the game's program, such as 1.0.3179.0, or "unknown".</summary>
    public string Build => fileVersion?.ToString() ?? "unknown";

    /// <summary>The game's name with its edition and build.</summary>
    public string Name => $"GTA V {Edition} {Build}";

    /// <summary>Why no camera can be mounted; null if one can. An unknown native would crash the game.</summary>
    public string? MountProblem =>
        !IsEnhanced && fileVersion is not null && fileVersion < FirstWithRigidCameras
            ? "This build of the game is older than 1.0.2189 and cannot attach a camera rigidly. Update the game."
            : null;

    /// <summary>
    /// Why nearby entities cannot be listed; null if they can. The API reads them from memory; in an unknown build that may crash the game.
    /// </summary>
    public string? ListProblem =>
        !IsEnhanced && fileVersion is not null && fileVersion >= FirstUnknownToRelease && Api < FirstApiForNewerBuilds
            ? "This build of the game is newer than ScriptHookVDotNet 3.6.0 knows."
            : null;

    /// <summary>The settings of the game that a session records.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> Settings =>
        [new("gameEdition", Edition), new("gameBuild", Build), new("scriptApi", Api.ToString())];

    /// <summary>Whether the game is Enhanced.</summary>
    public bool IsEnhanced => string.Equals(program, EnhancedProgram, StringComparison.OrdinalIgnoreCase);

    /// <summary>The game of this process.</summary>
    public static GameBuild OfThisProcess()
    {
        try
        {
            using var process = Process.GetCurrentProcess();
            ProcessModule module = process.MainModule!;
            FileVersionInfo version = module.FileVersionInfo;
            return new GameBuild(
                module.ModuleName!,
                new Version(version.FileMajorPart, version.FileMinorPart, version.FileBuildPart, version.FilePrivatePart)
            );
        }
        catch (Exception exception) when (exception is Win32Exception or InvalidOperationException or NotSupportedException)
        {
            return new GameBuild(string.Empty, null);
        }
    }
}
