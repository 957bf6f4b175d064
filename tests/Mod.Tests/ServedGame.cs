using System.Globalization;
using System.Net;
using System.Text;
using System.Windows.Forms;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

/// <summary>The test game, which counts 20 frames a second, with a street and a car that waits for a client or is driven by one.</summary>
public abstract class ServedGame
{
    private protected const int Steer = 59;
    private protected const int Accelerate = 71;
    private protected const int Brake = 72;
    private protected const int Handbrake = 76;

    /// <summary>Time that a client has between ticks.</summary>
    internal const int ClientsPauseMilliseconds = 2;

    private protected int Port { get; } = FreePort.Find();

    /// <summary>A file that appears whole.</summary>
    internal static void Drop(string folder, string name, string content)
    {
        string part = Path.Combine(folder, name + ".part");
        File.WriteAllText(part, content, new UTF8Encoding(false));
        File.Move(part, Path.Combine(folder, name), overwrite: true);
    }

    private protected static string Ini(int port) => string.Create(CultureInfo.InvariantCulture, $"[Bridge]\nPort = {port}\n");

    private protected static int BigEndian(byte[] bytes, int at) =>
        (bytes[at] << 24) | (bytes[at + 1] << 16) | (bytes[at + 2] << 8) | bytes[at + 3];

    private protected static void Street(TestGame game)
    {
        HarvestTests.Street(game);
        game.Entities[game.PlayersVehicle].Velocity = new Vector3D(0, 8, 0);
    }

    private protected static void Start(ScriptDriver driver)
    {
        int before = driver.Game.Notifications.Count;
        driver.Press(Keys.N);
        Until(
            driver,
            () =>
                driver
                    .Game.Notifications.Skip(before)
                    .Any(message => message.Contains("The car waits for a client", StringComparison.Ordinal))
        );
        driver.Tick(2);
        Assert.NotEmpty(driver.Game.Controls);
    }

    private protected static void Until(ScriptDriver driver, Func<bool> done) => driver.Until(done, ClientsPauseMilliseconds);

    private protected static void Say(ScriptDriver driver, SocketClient client, string message, Func<bool> done)
    {
        client.Send(message);
        Until(driver, done);
    }

    private protected ScriptDriver Driven(string more = "")
    {
        var driver = new ScriptDriver(Ini(Port) + more);
        Street(driver.Game);
        Start(driver);
        return driver;
    }

    /// <summary>A client that the game has welcomed.</summary>
    private protected SocketClient Connect()
    {
        var client = new SocketClient(new IPEndPoint(IPAddress.Loopback, Port));
        Assert.Equal("hello", client.ReceiveAny().Header.GetProperty("type").GetString());
        return client;
    }
}
