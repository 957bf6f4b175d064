using System.Runtime.InteropServices;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Terminals;

/// <summary>
/// Handles SIGINT and SIGTERM. The first signal lets the command finish the frame or file in progress. A command that still runs after a
/// few seconds, because it waits for input or is in a long operation, is ended; the files it has written are complete at every moment. A
/// second signal ends the process at once.
/// </summary>
internal sealed class StopSignals : IDisposable
{
    /// <summary>
    /// How long a command may take to end by itself. Containers and batch systems wait for 10 s or more before they kill.
    /// </summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(5);

    private readonly CancellationTokenSource _cancellation;
    private readonly PosixSignalRegistration _interrupt;
    private readonly PosixSignalRegistration _termination;
    private volatile bool _isTerminated;

    /// <summary>Receives the signals from now on.</summary>
    /// <param name="cancellation">Is cancelled by the first.</param>
    public StopSignals(CancellationTokenSource cancellation)
    {
        _cancellation = cancellation;
        _interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
        _termination = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
    }

    /// <summary>The exit code of a command that the first signal has stopped.</summary>
    public int ExitCode => _isTerminated ? Terminals.ExitCode.Terminated : Terminals.ExitCode.Cancelled;

    /// <inheritdoc/>
    public void Dispose()
    {
        _interrupt.Dispose();
        _termination.Dispose();
    }

    private void Stop(PosixSignalContext signal)
    {
        if (_cancellation.IsCancellationRequested)
        {
            WriterLock.AbandonAll();
            return;
        }

        signal.Cancel = true;
        _isTerminated = signal.Signal == PosixSignal.SIGTERM;
        new Thread(End) { IsBackground = true, Name = "end" }.Start();
        _cancellation.Cancel();
    }

    private void End()
    {
        Thread.Sleep(Patience);
        Console.Error.WriteLine("harvester: Stopped in the middle of an operation. All written files are complete; run the command again.");
        WriterLock.AbandonAll();
        Environment.Exit(ExitCode);
    }
}
