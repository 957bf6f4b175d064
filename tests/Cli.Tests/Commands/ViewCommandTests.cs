using System.Globalization;
using System.Net;
using System.Net.Sockets;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class ViewCommandTests
{
    [Fact]
    public void Folder_that_is_no_session_is_refused()
    {
        using var folder = new TemporaryFolder();

        CliRun.Of("view", folder.Path).AssertFailed(ExitCode.InputOutput, "is not a session");
    }

    [Fact]
    public void Port_in_use_is_named()
    {
        using var folder = new TemporaryFolder();
        SharedHarvest.CopyTo(folder.PathOf("session"), "--frames", "1", "--size", "80x60", "--no-report");
        using var taken = new TcpListener(IPAddress.Loopback, 0);
        taken.Start();
        string port = ((IPEndPoint)taken.LocalEndpoint).Port.ToString(CultureInfo.InvariantCulture);

        CliRun.Of("view", folder.PathOf("session"), "--port", port).AssertFailed(ExitCode.InputOutput, $"Port {port} is in use.");
    }

    [Fact]
    public async Task Stopped_viewer_has_printed_its_address()
    {
        using var folder = new TemporaryFolder();
        SharedHarvest.CopyTo(folder.PathOf("session"), "--frames", "1", "--size", "80x60", "--no-report");
        using var stopping = new CancellationTokenSource(TimeSpan.FromSeconds(2));

        CliRun run = await CliRun.StartAsync("", stopping.Token, "view", folder.PathOf("session"), "--no-open");

        Assert.Equal(ExitCode.Cancelled, run.ExitCode);
        Assert.Matches(@"^http://127\.0\.0\.1:\d+/[0-9a-f]{48}/0/\n$", run.Out);
    }
}
