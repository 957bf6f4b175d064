using System.CommandLine;
using System.Globalization;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Cli.Viewing;
using Harvester.Reports.Viewing;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Viewer;

namespace Harvester.Cli.Commands;

/// <summary>harvester view: serves sessions of any size to a browser on this machine.</summary>
internal static class ViewCommand
{
    private const int MaxPort = 65535;

    private const string Notes =
        "The page is that of 'harvester report', with all frames, masks, depth maps and LiDAR points, read from the session as\n"
        + "needed. A session that is still being written is followed. The server listens on 127.0.0.1 only, reads only, and answers only\n"
        + "requests with the random token in the address that it prints. Ctrl+C ends it.\n\n"
        + "Examples:\n"
        + "  harvester view out\n"
        + "  harvester view monday tuesday --port 8080 --no-open";

    public static Command Create(Terminal terminal)
    {
        var sessions = new Argument<string[]>("SESSION")
        {
            Description = "Folders of sessions; with several, the page lets you choose",
            Arity = ArgumentArity.OneOrMore,
        };
        Option<int?> port = ValueParsers.Optional<int>(
            "--port",
            "N",
            "Port to serve on [default: a free one]",
            PortOf,
            "a port from 0 to 65535; 0 is a free one"
        );
        var noOpen = new Option<bool>("--no-open")
        {
            Description = "Do not open the page in a browser; without a terminal it is not opened either",
        };
        var command = new ResultCommand("view", "Show sessions of any size in a browser.") { sessions, port, noOpen };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
            {
                bool isOpened = terminal.IsInteractive && !parsed.GetValue(noOpen);
                return ServeAsync(terminal, parsed.GetRequiredValue(sessions), parsed.GetValue(port) ?? 0, isOpened, cancellation);
            }
        );
        return command;
    }

    private static SessionView Open(string session)
    {
        try
        {
            return new SessionView(new SessionReader(session));
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{session}: {e.Message}", e);
        }
    }

    private static int? PortOf(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int port) && port <= MaxPort ? port : null;

    private static async Task<int> ServeAsync(Terminal terminal, string[] sessions, int port, bool isOpened, CancellationToken cancellation)
    {
        var views = new List<SessionView>();
        try
        {
            foreach (string session in sessions)
            {
                views.Add(Open(session));
            }

            await using ViewServer server = await ViewServer.StartAsync(views, port, cancellation).ConfigureAwait(false);
            terminal.Out.WriteLine(server.Address);
            await terminal.Out.FlushAsync(cancellation).ConfigureAwait(false);
            using AddressFile? opened = isOpened ? DefaultBrowser.Open(server.Address) : null;
            await Task.Delay(Timeout.Infinite, cancellation).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        }
        finally
        {
            views.ForEach(view => view.Dispose());
        }

        return ExitCode.Cancelled;
    }
}
