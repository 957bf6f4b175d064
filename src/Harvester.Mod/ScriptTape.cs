using Harvester.Capture.Ports;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Play.Surveys.Faces;
using Harvester.Play.Tapes;
using Harvester.Sessions.Semantics;

namespace Harvester.Mod;

/// <summary>The tape that the settings ask for, from the start of the script on.</summary>
internal static class ScriptTape
{
    /// <summary>Largest file on the tape, bytes: a playback takes 16 MiB of facts.</summary>
    private const int MaxFileBytes = 3 << 20;

    /// <summary>Starts a recording; null if the settings ask for none.</summary>
    /// <param name="folder">The files beside the mod.</param>
    /// <param name="player">The settings.</param>
    /// <param name="baseDirectory">The folder of the mod.</param>
    /// <param name="build">The game.</param>
    /// <param name="clock">Real time.</param>
    /// <param name="messages">Says when the recording ends.</param>
    public static TapeRecorder? Start(
        ModFolder folder,
        PlayerSettings player,
        string baseDirectory,
        GameBuild build,
        IClock clock,
        PlayerMessages messages
    )
    {
        if (player.Tape.Choice == TapeChoice.Off)
        {
            return null;
        }

        var tape = new TapeRecorder(player.Tape, clock, messages.Tell);
        tape.Fact(TapeFacts.Mod, typeof(ScriptTape).Assembly.GetName().Version!.ToString());
        tape.Fact(TapeFacts.Api, build.Api.ToString());
        tape.Fact(TapeFacts.Program, build.Program);
        if (build.FileVersion is { } version)
        {
            tape.Fact(TapeFacts.Build, version.ToString());
        }

        using (var settings = new StringReader(TextOf(folder.SettingsPath)))
        {
            tape.Fact(TapeFacts.Settings, TapeSettings.Filter(settings));
        }

        tape.Fact(TapeFacts.Faces, TextOf(Path.Combine(baseDirectory, ModFolder.FacesFile)));
        tape.Fact(TapeFacts.MeasuredFaces, TextOf(Path.Combine(player.FacesFolder, SurveyFolder.TableName)));
        tape.Fact(TapeFacts.Materials, TextOf(Path.Combine(baseDirectory, MaterialTable.FileName)));
        string rig = folder.Settings.Text("Harvest", "Rig", string.Empty);
        if (rig.Length > 0 && folder.Rig is not null)
        {
            tape.Fact(TapeFacts.Rig, TextOf(Path.Combine(baseDirectory, Environment.ExpandEnvironmentVariables(rig))));
        }

        return tape;
    }

    /// <summary>The text of a file; empty if it does not exist or the mod cannot use it.</summary>
    private static string TextOf(string path)
    {
        try
        {
            return new FileInfo(path) is { Exists: true, Length: <= MaxFileBytes } ? File.ReadAllText(path) : string.Empty;
        }
        catch (Exception exception)
            when (exception is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            return string.Empty;
        }
    }
}
