using System.Net;
using System.Net.Sockets;
using Harvester.Cli.Commands;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>Runs a command that serves a game in lock-step, with a client that asks for a frame and takes two steps.</summary>
internal static class ServedRun
{
    private const string Announcement = "Serving at ";
    private const string Step = """{"type":"step","seconds":0.2}""";
    private static readonly string[] Requests = ["""{"type":"requestFrame"}""", Step, Step];

    public static CliRun Of(params string[] arguments)
    {
        var output = new AnnouncedPlace { NewLine = "\n" };
        var error = new StringWriter { NewLine = "\n" };
        var terminal = new Terminal(TextReader.Null, output, error, IsInteractive: false);
        int code = Application.RunAsync(arguments, terminal, CancellationToken.None).GetAwaiter().GetResult();
        output.Client?.Join();
        return new CliRun(code, output.ToString(), error.ToString());
    }

    private static void Drive(IPEndPoint game)
    {
        try
        {
            using var client = new SocketClient(game);
            foreach (string request in Requests)
            {
                client.Send(request);
                client.Receive();
            }
        }
        catch (Exception e) when (e is IOException or SocketException)
        {
            // A game whose disk has failed ends.
            return;
        }
    }

    /// <summary>What the command prints; its client begins as soon as the place is printed.</summary>
    private sealed class AnnouncedPlace : StringWriter
    {
        public Thread? Client { get; private set; }

        public override void Flush()
        {
            base.Flush();
            string text = ToString();
            if (Client is null && text.StartsWith(Announcement, StringComparison.Ordinal))
            {
                IPEndPoint place = IPEndPoint.Parse(text[Announcement.Length..text.IndexOf('\n', StringComparison.Ordinal)]);
                Client = new Thread(() => Drive(place)) { IsBackground = true };
                Client.Start();
            }
        }
    }
}
