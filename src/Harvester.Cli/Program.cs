using Harvester.Cli.Commands;
using Harvester.Cli.Terminals;
using Harvester.Runs.Supervising;

if (args is ["supervise", ..])
{
    ProcessFamily.AdoptOrphans();
}

using var cancellation = new CancellationTokenSource();
using var signals = new StopSignals(cancellation);
int code = await Application.RunAsync(args, Terminal.OfProcess(), cancellation.Token).ConfigureAwait(false);
return code == ExitCode.Cancelled ? signals.ExitCode : code;
