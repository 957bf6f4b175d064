using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Capture.SelfTests;
using Harvester.Capture.Storage;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Sessions.SelfTests;
using Harvester.Sessions.Text;

namespace Harvester.Play.SelfTests;

/// <summary>
/// Runs the self-test in the game, writes its results and pictures into one zip, and changes the settings where the answer is clear. The
/// settings file is copied before it is changed. Nothing waits for the disk.
/// </summary>
/// <param name="harvest">Its options are tested, and receive the measured lens.</param>
/// <param name="game">The game.</param>
/// <param name="mount">The camera of the test.</param>
/// <param name="messages">Reports the result.</param>
/// <param name="folder">The folder of the sessions, into which the zip goes.</param>
/// <param name="iniPath">The settings file.</param>
/// <param name="origin">Names the mod and the game.</param>
public sealed class SelfTesting(
    Harvest harvest,
    GamePorts game,
    IMount mount,
    PlayerMessages messages,
    string folder,
    string iniPath,
    Func<SessionOrigin> origin
) : ILastingFeature, IDisposable
{
    /// <summary>Ticks between two checks: a second, in which the line of progress is shown until the lag of pictures forbids it.</summary>
    private const int PauseTicks = PictureLag.MaxTicks;

    private const string BackupSuffix = ".before-selftest";
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(10);
    private readonly DiskQueue _disk = new();
    private SelfTest? _test;
    private string? _written;

    /// <inheritdoc/>
    public string Name => "The self-test";

    /// <inheritdoc/>
    public bool IsOn => _test is not null;

    /// <inheritdoc/>
    public bool IsBusy => _disk.IsBusy;

    /// <summary>Why it cannot begin; null if it can.</summary>
    public Func<string?> Obstacle { get; init; } = static () => null;

    /// <summary>Whether a picture is grabbed now or so soon that nothing may be drawn over it.</summary>
    public bool IsPictureNear => _test is { IsPictureNear: true };

    /// <summary>The progress in one line; null while it is off.</summary>
    public string? Line => _test?.Progress;

    /// <summary>Starts the self-test, or ends the one that is running.</summary>
    public void Toggle()
    {
        if (_test is not null)
        {
            Stop();
            messages.Tell("The self-test was stopped.");
            return;
        }

        if ((harvest.IsOn ? "End the harvest first, then start the self-test." : Obstacle()) is { } obstacle)
        {
            messages.Tell(obstacle);
            return;
        }

        if (!mount.IsMounted)
        {
            mount.Mount();
        }

        if (mount.IsMounted)
        {
            messages.Tell("The self-test takes up to five minutes. Stay in the vehicle and touch nothing.");
            game.Hud?.Hide();
            _test = new SelfTest(harvest.Options, game, PauseTicks);
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        TellWritten();
        if (_test is not { } test)
        {
            return;
        }

        if (!mount.IsMounted)
        {
            Stop();
            messages.Tell("The self-test was stopped, because the camera is not mounted any more.");
        }
        else if (test.Step() == SelfTestPhase.Done)
        {
            Stop();
            End(test);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        _test?.Dispose();
        _test = null;
        game.Hud?.Restore();
    }

    /// <summary>Stops, and waits until the zip is written, or for as long as a script may take to end.</summary>
    public void Finish()
    {
        Stop();
        _disk.Wait(MaxWaitForDisk);
        TellWritten();
    }

    /// <summary>Stops.</summary>
    public void Dispose() => Stop();

    private void End(SelfTest test)
    {
        foreach (SelfTestLine line in test.Lines)
        {
            messages.Log($"Self-test: {line.Check}: {JsonName.Of(line.Verdict)}: {line.Sentence}");
        }

        KeyValuePair<string, string>[] changes = [.. ChangesOf(test)];
        if (test.NeededLens is { } lens)
        {
            harvest.Options = harvest.Options with { Lens = lens };
        }

        SessionOrigin named = origin();
        string json = SelfTestJson.Text(
            named.Tool,
            named.Game,
            test.Phase == SelfTestPhase.Done,
            test.Lines,
            changes,
            test.Pictures.Select(picture => picture.Name + ".png")
        );
        string path = SessionPlace.NewIn(folder, "selftest") + ".zip";
        int problems = test.Lines.Count(line => line.Verdict == SelfTestVerdict.Problem);
        _written =
            $"The self-test ended: {Counted.Of(problems, "problem")}. {path} has the results; harvester doctor explains them."
            + (
                changes.Length == 0
                    ? string.Empty
                    : $" {string.Join(", ", changes.Select(change => $"{change.Key} = {change.Value}"))} was written to the ini; "
                        + "restart the scripts to use it."
            );
        _disk.Add(() =>
        {
            SelfTestArchive.Write(path, json, test);
            Change(test, changes.Length > 0);
        });
    }

    private static IEnumerable<KeyValuePair<string, string>> ChangesOf(SelfTest test)
    {
        if (test.ClearFreeze is { } freeze)
        {
            yield return new("Freeze", freeze.ToString());
        }

        if (test.NeededLagTicks is { } lag)
        {
            yield return new("MaxPictureLagTicks", lag.ToString(CultureInfo.InvariantCulture));
        }

        foreach (KeyValuePair<string, double> value in test.NeededLens is { } lens ? LensSettings.ValuesOf(lens) : [])
        {
            yield return new(value.Key, value.Value.ToString("0.########", CultureInfo.InvariantCulture));
        }
    }

    private void Change(SelfTest test, bool isAny)
    {
        if (!isAny)
        {
            return;
        }

        if (File.Exists(iniPath))
        {
            File.Copy(iniPath, iniPath + BackupSuffix, overwrite: true);
        }

        if (test.ClearFreeze is { } freeze)
        {
            IniEditor.Set(iniPath, HarvestSettings.HarvestSection, "Freeze", freeze.ToString());
        }

        if (test.NeededLagTicks is { } lag)
        {
            IniEditor.Set(iniPath, HarvestSettings.HarvestSection, [new("MaxPictureLagTicks", lag)]);
        }

        if (test.NeededLens is { } lens)
        {
            IniEditor.Set(iniPath, LensSettings.Section, LensSettings.ValuesOf(lens));
        }
    }

    private void TellWritten()
    {
        if (_written is not { } written || _disk.IsBusy)
        {
            return;
        }

        _written = null;
        messages.Tell(_disk.TakeFailure() is { } failure ? $"The results of the self-test cannot be written: {failure.Message}" : written);
    }
}
