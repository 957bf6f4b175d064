using System;
using System.Threading;
using Harvester.Cli;

using var cancellation = new CancellationTokenSource();
Console.CancelKeyPress += (_, pressed) =>
{
    // The first Ctrl+C lets the command finish the frame in hand; a second one ends the process.
    pressed.Cancel = !cancellation.IsCancellationRequested;
    cancellation.Cancel();
};
return await Application.RunAsync(args, Terminal.OfProcess(), cancellation.Token).ConfigureAwait(false);
