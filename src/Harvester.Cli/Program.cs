using System.Runtime.InteropServices;
using System.Threading;
using Harvester.Cli.Commands;
using Harvester.Cli.Terminals;

using var cancellation = new CancellationTokenSource();
bool isTerminated = false;
using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
using PosixSignalRegistration termination = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
int code = await Application.RunAsync(args, Terminal.OfProcess(), cancellation.Token).ConfigureAwait(false);
return code == ExitCode.Cancelled && isTerminated ? ExitCode.Terminated : code;

// The first signal lets the command finish what it has in hand; a second one ends the process.
void Stop(PosixSignalContext signal)
{
    isTerminated |= signal.Signal == PosixSignal.SIGTERM && !cancellation.IsCancellationRequested;
    signal.Cancel = !cancellation.IsCancellationRequested;
    cancellation.Cancel();
}
