using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;

namespace Harvester.Cli.Tests.Supervising;

/// <summary>
/// A program to supervise, in place of a game: with --resume it finishes; before, it does what its behaviour says. Each start adds a line
/// to the file starts in its folder.
/// </summary>
internal static class StandIn
{
    /// <summary>Name of the file with a line for each start: the arguments after the behaviour.</summary>
    public const string Starts = "starts";

    /// <summary>Name of the file with the number of a process that the program has started.</summary>
    public const string Helper = "helper";

    /// <summary>Name of the file with the signal that stopped the program.</summary>
    public const string Stopped = "stopped";

    private static readonly TimeSpan Beat = TimeSpan.FromMilliseconds(20);

    public static int Run(string folder, string behaviour, string[] more)
    {
        if (behaviour != "launched")
        {
            File.AppendAllText(Path.Combine(folder, Starts), string.Join(' ', more) + "\n");
        }

        if (more.Contains("--resume") && !behaviour.EndsWith("-always", StringComparison.Ordinal))
        {
            Write(folder, "running", frames: 2);
            Write(folder, "finished", frames: 2);
            return 0;
        }

        return behaviour switch
        {
            "hangs" => Hang(folder),
            "leaves-daemon" => LeaveDaemon(folder),
            "crashes" or "crashes-always" => Crash(folder),
            "quits" => 0,
            "skips" => Skip(folder),
            "launches" => Launch(folder),
            "launched" => Play(folder),
            "stalls" => BeatFor(folder, "running"),
            "lingers" => BeatFor(folder, "finished"),
            "claims-other-process" => BeatFor(folder, "running", process: 1),
            "claims-future" => BeatFor(folder, "running", ahead: TimeSpan.FromHours(1)),
            "writes-rubbish" => Rubbish(folder),
            "ends-on-signal" => EndOnSignal(folder),
            _ => throw new ArgumentException($"no behaviour '{behaviour}'"),
        };
    }

    private static int Hang(string folder)
    {
        using Process? helper = OperatingSystem.IsWindows() ? null : Process.Start("sleep", "600");
        File.WriteAllText(Path.Combine(folder, Helper), $"{helper?.Id}");
        Write(folder, "running", frames: 1);
        return Wait();
    }

    /// <summary>Starts a process that leaves its session and its parent.</summary>
    private static int LeaveDaemon(string folder)
    {
        using (Process shell = Process.Start("setsid", ["sh", "-c", $"sleep 600 > /dev/null & echo $! > {Path.Combine(folder, Helper)}"]))
        {
            shell.WaitForExit();
        }

        Write(folder, "running", frames: 1);
        return Wait();
    }

    private static int Crash(string folder)
    {
        Write(folder, "running", frames: 1);
        return 9;
    }

    private static int Skip(string folder)
    {
        Write(folder, "incomplete", frames: 1);
        return 4;
    }

    /// <summary>Starts a game that gives its first sign of life when this process is gone.</summary>
    private static int Launch(string folder)
    {
        using var game = Process.Start("dotnet", [typeof(StandIn).Assembly.Location, "stand-in", folder, "launched"]);
        return 0;
    }

    private static int Play(string folder)
    {
        Thread.Sleep(TimeSpan.FromSeconds(1));
        Write(folder, "running", frames: 1);
        Thread.Sleep(TimeSpan.FromSeconds(1));
        Write(folder, "finished", frames: 1);
        return 0;
    }

    private static int Rubbish(string folder)
    {
        File.WriteAllText(Path.Combine(folder, "heartbeat.json"), "{\"process\": 1e99, " + new string('x', 100_000));
        return Wait();
    }

    private static int Wait()
    {
        Thread.Sleep(Timeout.Infinite);
        return 0;
    }

    private static int BeatFor(string folder, string state, int? process = null, TimeSpan ahead = default)
    {
        while (true)
        {
            Write(folder, state, frames: 1, process, ahead);
            Thread.Sleep(Beat);
        }
    }

    private static int EndOnSignal(string folder)
    {
        using var stop = new ManualResetEventSlim();
        using PosixSignalRegistration terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
        using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
        do
        {
            Write(folder, "running", frames: 1);
        } while (!stop.Wait(Beat));
        return 0;

        void Stop(PosixSignalContext signal)
        {
            signal.Cancel = true;
            File.WriteAllText(Path.Combine(folder, Stopped), $"{signal.Signal}");
            stop.Set();
        }
    }

    private static void Write(string folder, string state, int frames, int? process = null, TimeSpan ahead = default)
    {
        string time = (DateTime.UtcNow + ahead).ToString("O", CultureInfo.InvariantCulture);
        string path = Path.Combine(folder, "heartbeat.json");
        File.WriteAllText(
            path + ".new",
            $$"""
            {"process": {{process ?? Environment.ProcessId}}, "time": "{{time}}", "state": "{{state}}", "trial": null, "frames": {{frames}}}
            """
        );
        File.Move(path + ".new", path, overwrite: true);
    }
}
