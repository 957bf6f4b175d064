using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Windows.Forms;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

/// <summary>Clients that make errors, and bridges that cannot be opened: the player gets a message, and the next attempt works.</summary>
public sealed class BridgeFaultTests : ServedGame
{
    [Fact]
    public void Problem_of_one_drive_is_logged_again_in_the_next()
    {
        using ScriptDriver driver = Driven();
        for (int drive = 1; drive <= 2; drive++)
        {
            using SocketClient client = Connect();
            client.Send("""{"type":"wrong"}""");
            Until(driver, () => driver.Log().Split('\n').Count(line => line.Contains("type 'wrong'", StringComparison.Ordinal)) == drive);
            driver.Press(Keys.N);
            Start(driver);
        }
    }

    [Fact]
    public void Malformed_clients_are_cut_off_and_the_next_one_is_served()
    {
        using ScriptDriver driver = Driven();
        var random = new Random(7);
        for (int i = 0; i < 20; i++)
        {
            using SocketClient client = Connect();
            byte[] bytes = new byte[random.Next(8, 200)];
            random.NextBytes(bytes);
            client.Stream.Write(bytes);
            driver.Tick();
            Assert.Equal((0f, 1f), (driver.Game.Controls.GetValueOrDefault(Accelerate), driver.Game.Controls.GetValueOrDefault(Brake, 1f)));
        }

        using SocketClient good = Connect();
        Say(driver, good, """{"type":"controls","steering":0.5,"throttle":0,"brake":0}""", () => driver.Game.Controls[Steer] != 0);
        Assert.Equal(-0.5f, driver.Game.Controls[Steer]);
    }

    [Fact]
    public void Clients_that_err_endlessly_do_not_fill_the_log()
    {
        using ScriptDriver driver = Driven();
        for (int i = 0; i < 150; i++)
        {
            using SocketClient client = Connect();
            client.Send(string.Create(CultureInfo.InvariantCulture, $$"""{"type":"wrong {{i}}"}"""));
            Assert.True(client.IsCutOff());
            driver.Tick();
        }

        Assert.Equal(100, driver.Log().Split('\n').Count(line => line.Contains("The bridge: ", StringComparison.Ordinal)));
        Assert.Contains("No more problems of this drive are logged.", driver.Log(), StringComparison.Ordinal);
        driver.Press(Keys.N);
        Start(driver);
        using SocketClient next = Connect();
        next.Send("""{"type":"wrong again"}""");
        Until(driver, () => driver.Log().Contains("wrong again", StringComparison.Ordinal));
    }

    [Fact]
    public void Port_in_use_is_reported_and_a_retry_works()
    {
        using var driver = new ScriptDriver(Ini(Port));
        Street(driver.Game);
        var other = new TcpListener(IPAddress.Loopback, Port);
        other.Start();
        driver.Press(Keys.N);
        driver.UntilMessage("The drive failed");
        other.Dispose();
        Start(driver);
    }

    [Fact]
    public void Address_that_others_reach_without_a_token_is_refused()
    {
        using var driver = new ScriptDriver(Ini(Port) + "Address = 0.0.0.0\n");
        Street(driver.Game);
        driver.Press(Keys.N);
        driver.UntilMessage("needs a token");
    }

    [Fact]
    public void Disabled_bridge_is_reported()
    {
        using var driver = new ScriptDriver("[Bridge]\nKind = Off\n");
        Street(driver.Game);
        driver.Press(Keys.N);

        Assert.Contains("Change Kind under [Bridge]", Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
    }
}
