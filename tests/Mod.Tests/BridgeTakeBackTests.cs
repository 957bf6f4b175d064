using System.Windows.Forms;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

/// <summary>The player takes the car back from a client, and nothing that the client does is mistaken for the player.</summary>
public sealed class BridgeTakeBackTests : ServedGame
{
    [Theory]
    [InlineData(63)]
    [InlineData(64)]
    [InlineData(75)]
    [InlineData(76)]
    [InlineData(87)]
    [InlineData(88)]
    public void Players_control_takes_the_car_back(int control)
    {
        using ScriptDriver driver = Driven();
        driver.Game.PlayersControls.Add(control);
        driver.Tick(2);

        Assert.Contains("The car is yours.", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.Empty(driver.Game.Controls);
        driver.Game.PlayersControls.Clear();
        driver.Tick(5);
        Assert.Empty(driver.Game.Controls);
    }

    [Theory]
    [InlineData(Keys.W)]
    [InlineData(Keys.A)]
    [InlineData(Keys.S)]
    [InlineData(Keys.D)]
    [InlineData(Keys.Space)]
    public void Players_key_takes_the_car_back_on_press(Keys key)
    {
        using ScriptDriver driver = Driven();
        driver.Script.RaiseKeyDown(key);
        driver.Tick(2);

        Assert.Contains("You are driving again.", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.Empty(driver.Game.Controls);
    }

    [Fact]
    public void Keys_that_take_the_car_back_can_be_changed()
    {
        using ScriptDriver driver = Driven("TakeBackKeys = Left, Z\n");
        driver.Script.RaiseKeyDown(Keys.W);
        driver.Tick(2);
        Assert.NotEmpty(driver.Game.Controls);

        driver.Script.RaiseKeyDown(Keys.Z);
        driver.Tick(2);
        Assert.Contains("You are driving again.", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.Empty(driver.Game.Controls);
    }

    [Theory]
    [InlineData("TakeBackKeys = W, Banana", "Line 3: TakeBackKeys = W, Banana is not keys, separated by commas")]
    [InlineData("TakeBackKeys = W, N", "the key N has two uses")]
    public void Keys_that_cannot_take_the_car_back_are_reported(string line, string complaint)
    {
        using var driver = new ScriptDriver(Ini(Port) + line + "\n");
        driver.Tick();

        Assert.Contains(complaint, Assert.Single(driver.Game.Notifications), StringComparison.Ordinal);
    }

    [Fact]
    public void Full_controls_of_the_client_are_not_mistaken_for_the_players()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        Say(driver, client, """{"type":"controls","steering":1,"throttle":1,"brake":0}""", () => driver.Game.Controls[Steer] != 0);
        driver.Tick(5);
        Assert.Equal((-1f, 1f), (driver.Game.Controls[Steer], driver.Game.Controls[Accelerate]));
        driver.Game.Entities[driver.Game.PlayersVehicle].Velocity = default;
        driver.Tick(20);

        Assert.Equal(1f, driver.Game.Controls[Handbrake]);
    }

    [Fact]
    public void Released_client_handbrake_is_not_mistaken_for_the_players()
    {
        using ScriptDriver driver = Driven();
        using SocketClient client = Connect();
        driver.Game.Entities[driver.Game.PlayersVehicle].Velocity = default;
        driver.Tick(2);
        Assert.Equal(1f, driver.Game.Controls[Handbrake]);
        Say(driver, client, """{"type":"controls","steering":0,"throttle":1,"brake":0}""", () => driver.Game.Controls[Accelerate] == 1);
        driver.Tick(3);
        Assert.False(driver.Game.Controls.ContainsKey(Handbrake));
        driver.Game.PlayersControls.Add(Handbrake);
        driver.Tick(1);

        Assert.Contains("The car is yours.", driver.Game.Notifications[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Player_who_leaves_the_car_is_not_driven_on_foot()
    {
        using ScriptDriver driver = Driven();
        driver.Game.PlayersVehicle = 0;
        driver.Tick(2);

        Assert.Contains("The car is yours.", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.Empty(driver.Game.Controls);
    }
}
