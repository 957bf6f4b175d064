using System.Windows.Forms;
using GTA.Hosting;
using Harvester.Mod;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Play.Surveys.Faces;
using Harvester.Play.Tapes;
using Harvester.Sessions.Semantics;

namespace Harvester.Tapes;

/// <summary>Runs the mod's own code against a tape. One tape plays at a time in a process; others wait.</summary>
public static class TapePlayer
{
    /// <summary>
    /// What the tape cannot set: sessions go into the folder of the playback, nothing listens for clients, the disk need not be as free as
    /// the player's, and few pictures wait in memory.
    /// </summary>
    private const string Own = "\n[Harvest]\nFolder = sessions\nMinFree = 0\nQueue = 4\n[Bridge]\nKind = Off\n";

    private const string RigFile = "rig.json";

    /// <summary>Most ticks and keys: the longest recording, 10 minutes, at 1,000 ticks a second, and its keys.</summary>
    private const int MaxEvents = 1_000_000;

    /// <summary>Longer than the mod takes to write a frame, or all that waits, on a disk that is not broken.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(20);

    /// <summary>The stand-in has one game in a process.</summary>
    private static readonly Lock Gate = new();

    /// <summary>Plays a tape to its end or to the first difference.</summary>
    /// <param name="file">The tape.</param>
    /// <param name="folder">An empty folder for the files of the mod and its sessions.</param>
    /// <param name="cancellation">Ends the playback at the next call.</param>
    /// <exception cref="InvalidDataException">The tape is damaged or none.</exception>
    /// <exception cref="IOException">The tape cannot be read, or the folder not written.</exception>
    public static TapeResult Play(Stream file, string folder, CancellationToken cancellation)
    {
        lock (Gate)
        {
            return PlayAlone(file, folder, cancellation);
        }
    }

    private static TapeResult PlayAlone(Stream file, string folder, CancellationToken cancellation)
    {
        var reader = new TapeReader(file);
        using var tape = new TapeCursor(reader.Entries(), cancellation);
        Dictionary<string, string> facts = tape.TakeFacts();
        tape.Fault?.Throw();
        WriteFiles(facts, folder);
        GameHost.Current = new PlayedHost(folder);
        HarvesterScript script = ScriptThread.Run(() =>
            new HarvesterScript(
                new PlayedScreen(tape),
                new PlayedClock(tape),
                BuildOf(facts),
                Path.Combine(folder, "settings.xml"),
                new PlayedApi(tape),
                new PlayedBackground(tape, Patience)
            )
        );
        int played;
        try
        {
            played = PlayEvents(script, tape);
        }
        finally
        {
            script.RaiseAborted();
            SpinWait.SpinUntil(() => !script.IsBusy, Patience);
        }

        cancellation.ThrowIfCancellationRequested();
        tape.Fault?.Throw();
        if (tape.Difference is not null)
        {
            CheckSpace(folder);
        }

        return !script.IsBusy
            ? new TapeResult(played, tape.Calls, reader.IsInterrupted, facts.GetValueOrDefault(TapeFacts.Mod, "unknown"), tape.Difference)
            : throw new IOException($"The sessions of the playback in '{folder}' are still being written: the disk is too slow.");
    }

    /// <summary>Raises the events of the tape; returns the ticks played to their end.</summary>
    private static int PlayEvents(HarvesterScript script, TapeCursor tape)
    {
        int played = 0;
        for (int events = 1; tape.TakeEvent() is { } entry; events++)
        {
            if (events > MaxEvents)
            {
                throw new InvalidDataException("it exceeds the limit of 1,000,000 ticks and keys.");
            }

            Raise(script, entry);
            if (tape.Fault is not null)
            {
                break;
            }

            played += entry is TapeTick && tape.Difference is null ? 1 : 0;
        }

        return played;
    }

    private static void Raise(HarvesterScript script, TapeEntry entry)
    {
        try
        {
            switch (entry)
            {
                case TapeKey { IsDown: true } key:
                    script.RaiseKeyDown((Keys)key.Key);
                    break;
                case TapeKey key:
                    script.RaiseKeyUp((Keys)key.Key);
                    break;
                default:
                    script.RaiseTick();
                    break;
            }
        }
        catch (TapeStoppedException)
        {
            // The cursor knows why.
        }
    }

    private static void WriteFiles(Dictionary<string, string> facts, string folder)
    {
        using var recorded = new StringReader(facts.GetValueOrDefault(TapeFacts.Settings, ""));
        string rig = facts.ContainsKey(TapeFacts.Rig) ? $"[Harvest]\nRig = {RigFile}\n" : "";
        string settings = TapeSettings.Filter(recorded) + Own + rig;
        File.WriteAllText(Path.Combine(folder, "GtaDataHarvester.ini"), settings);
        Write(ModFolder.FacesFile, TapeFacts.Faces);
        Write(MaterialTable.FileName, TapeFacts.Materials);
        Write(RigFile, TapeFacts.Rig);
        Directory.CreateDirectory(Path.Combine(folder, "sessions", "spaces"));
        Write(Path.Combine("sessions", "spaces", SurveyFolder.TableName), TapeFacts.MeasuredFaces);
        CheckSize(folder);

        void Write(string name, string fact)
        {
            if (facts.TryGetValue(fact, out string? text) && text.Length > 0)
            {
                File.WriteAllText(Path.Combine(folder, name), text);
            }
        }
    }

    /// <summary>A mod that cannot write asks the game for other things, which is no difference of the mod.</summary>
    /// <exception cref="IOException">The disk is full.</exception>
    private static void CheckSpace(string folder)
    {
        const int uncompressedFrame = 4 * 800 * 600;
        File.WriteAllBytes(Path.Combine(folder, "space"), new byte[uncompressedFrame]);
    }

    /// <summary>A tape may come from anyone: larger pictures would take too much memory.</summary>
    private static void CheckSize(string folder)
    {
        const long maxPixels = 3840 * 2160;
        var files = new ModFolder(folder);
        long pixels = files.Rig is { } rig
            ? rig.Cameras.Sum(camera => camera.Image.PixelCount) / 2
            : PlayerSettings.Read(files.Settings, folder).Options.Image.PixelCount;
        if (pixels > maxPixels)
        {
            throw new InvalidDataException("its pictures exceed the limit of 3840 x 2160 pixels, or twice that for all cameras of a rig.");
        }
    }

    private static GameBuild BuildOf(Dictionary<string, string> facts) =>
        new(facts.GetValueOrDefault(TapeFacts.Program, ""), VersionOf(TapeFacts.Build, facts), VersionOf(TapeFacts.Api, facts));

    private static Version? VersionOf(string fact, Dictionary<string, string> facts) =>
        facts.TryGetValue(fact, out string? text) && Version.TryParse(text, out Version? version) ? version : null;
}
