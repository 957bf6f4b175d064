using System.ComponentModel;
using System.Diagnostics;
using System.Runtime.InteropServices;

namespace Harvester.Runs.Supervising;

/// <summary>
/// One start of the program, with the processes that it starts. A launcher that ends when the game runs leaves the process that the
/// heartbeat names.
/// </summary>
public sealed class SupervisedProcess : IDisposable
{
    private const int KillSignal = 9;

    // The system gives times of start in steps, and so does the clock.
    private static readonly TimeSpan StartTolerance = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan EndPatience = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(20);

    private readonly Process _command;
    private readonly ProcessFamily _family;
    private readonly DateTime _begun = DateTime.Now;
    private Process? _adopted;

    private SupervisedProcess(Process command, ProcessFamily family)
    {
        _command = command;
        _family = family;
    }

    /// <summary>Number of the process that is watched.</summary>
    public int Id => (_adopted ?? _command).Id;

    /// <summary>Whether the process that is watched has ended.</summary>
    public bool HasEnded => (_adopted ?? _command).HasExited;

    /// <summary>Whether the command itself is watched, and not a process that it left.</summary>
    public bool IsCommand => _adopted is null;

    /// <summary>How the process that is watched ended, as text.</summary>
    public string Ending => _adopted is null ? FormattableString.Invariant($"exit code {_command.ExitCode}") : "exit code unknown";

    /// <summary>Starts a program, which shares the terminal with this one.</summary>
    /// <exception cref="IOException">It cannot be started.</exception>
    public static SupervisedProcess Start(ProcessStartInfo start)
    {
        var family = new ProcessFamily();
        start.Environment[ProcessFamily.Variable] = family.Mark;
        try
        {
            return new SupervisedProcess(Process.Start(start)!, family);
        }
        catch (Win32Exception e)
        {
            throw new IOException($"'{start.FileName}' cannot be started: {e.Message.TrimEnd('.')}. Check its name and permissions.", e);
        }
    }

    /// <summary>Whether a process can be the program's: it runs, and was not there before the program was started.</summary>
    public bool IsOurs(int id)
    {
        if (id == _command.Id || id == _adopted?.Id)
        {
            return true;
        }

        using Process? process = Find(id);
        return process is not null;
    }

    /// <summary>Watches the process of a heartbeat in place of a launcher that has ended.</summary>
    /// <returns>Whether there is such a process.</returns>
    public bool TryAdopt(int id)
    {
        Process? found = _adopted is null && id != _command.Id ? Find(id) : null;
        _adopted = found ?? _adopted;
        return found is not null;
    }

    /// <summary>Passes a signal on to the process that is watched; the program may end in good order.</summary>
    public void Send(PosixSignal signal)
    {
        if (!HasEnded)
        {
            Send(Id, signal);
        }
    }

    /// <summary>
    /// Waits until the program and all processes that it started have ended. Those that remain when the process that is watched has ended
    /// get the signal too: a shell, for example, does not pass it on.
    /// </summary>
    /// <returns>Whether all have ended.</returns>
    public bool WaitForEnd(TimeSpan patience, PosixSignal signal)
    {
        var time = Stopwatch.StartNew();
        if (!(_adopted ?? _command).WaitForExit(patience))
        {
            return false;
        }

        foreach (int left in Running())
        {
            Send(left, signal);
        }

        while (Running().Count > 0 && time.Elapsed < patience)
        {
            Thread.Sleep(Pause);
        }

        return Running().Count == 0;
    }

    /// <summary>Ends the program and all processes that it started, and waits for that.</summary>
    public void End()
    {
        foreach (Process? process in (Process?[])[_adopted, _command])
        {
            try
            {
                process?.Kill(entireProcessTree: true);
            }
            catch (Exception e) when (e is InvalidOperationException or Win32Exception or AggregateException)
            {
                // It has ended meanwhile, or belongs to somebody else by now.
                continue;
            }
        }

        // A process that is ended may just have started another.
        var time = Stopwatch.StartNew();
        while (time.Elapsed < EndPatience && Running() is { Count: > 0 } left)
        {
            foreach (int id in left)
            {
                _ = Kill(id, KillSignal);
            }

            Thread.Sleep(Pause);
        }

        (_adopted ?? _command).WaitForExit(EndPatience);
    }

    /// <inheritdoc />
    public void Dispose()
    {
        _adopted?.Dispose();
        _command.Dispose();
    }

    private IReadOnlyList<int> Running() =>
        _family.Running(new[] { _adopted, _command }.OfType<Process>().Where(process => !process.HasExited).Select(process => process.Id));

    private static void Send(int process, PosixSignal signal)
    {
        if (!OperatingSystem.IsWindows())
        {
            const int interrupt = 2;
            const int terminate = 15;
            _ = Kill(process, signal == PosixSignal.SIGINT ? interrupt : terminate);
        }
    }

    private Process? Find(int id)
    {
        Process? process = null;
        try
        {
            process = Process.GetProcessById(id);
            if (!process.HasExited && process.StartTime >= _begun - StartTolerance)
            {
                return process;
            }
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException or Win32Exception or NotSupportedException)
        {
            // There is no such process, or it is the system's.
            process?.Dispose();
            return null;
        }

        process.Dispose();
        return null;
    }

    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    [DllImport("libc", EntryPoint = "kill")]
    private static extern int Kill(int process, int signal);
}
