using System.Net;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Geometry.Cameras;
using Harvester.Play.Settings;
using Harvester.Sessions.Text;

namespace Harvester.Play.Tests.Settings;

public sealed class BridgeSettingsTests
{
    [Fact]
    public void Section_is_read()
    {
        BridgeSettings settings = Read(
            """
            [Bridge]
            Kind = folder
            Folder = shared
            ClientPatience = 600
            Address = 192.168.1.20
            Port = 5000
            Token = open sesame
            Rate = 5
            Width = 320
            Height = 240
            Controller = Stanley
            EmergencyBrake = On
            """
        );

        Assert.Equal(BridgeKind.Folder, settings.Kind);
        Assert.Equal("/mod/shared", settings.Folder);
        Assert.Equal(settings.Folder, settings.Place);
        Assert.Equal(600, settings.ClientPatienceSeconds);
        Assert.Equal(new SocketBridgeOptions(IPAddress.Parse("192.168.1.20"), 5000, "open sesame"), settings.Socket);
        Assert.Equal(5, settings.Driving.RateHz);
        Assert.Equal(new ImageSize(320, 240), settings.Driving.Picture);
        Assert.Equal((ControllerKind.Stanley, true), (settings.Controller.Kind, settings.Controller.BrakesInEmergency));
    }

    [Fact]
    public void Default_is_a_loopback_socket_without_a_token()
    {
        BridgeSettings settings = Read("");

        Assert.Equal(BridgeKind.Socket, settings.Kind);
        Assert.Equal(SocketBridgeOptions.Loopback, settings.Socket);
        Assert.Equal("127.0.0.1:4567", settings.Place);
        Assert.Equal("/mod/default", settings.Folder);
        Assert.Equal(30, settings.ClientPatienceSeconds);
        Assert.Equal(10, settings.Driving.RateHz);
        Assert.Equal(new ImageSize(280, 210), settings.Driving.Picture);
        Assert.Equal((ControllerKind.DeepDriving, false), (settings.Controller.Kind, settings.Controller.BrakesInEmergency));
    }

    [Theory]
    [InlineData("Kind = Wire", "Socket, Folder or Off")]
    [InlineData("Address = here", "an address such as 127.0.0.1")]
    [InlineData("Port = 0", "1 to 65535")]
    [InlineData("Rate = 0", "0.1 to 60")]
    [InlineData("ClientPatience = 0", "1 to 86400")]
    [InlineData("Controller = Rails", "DeepDriving or Stanley")]
    public void Unreadable_value_is_reported_and_has_its_default(string line, string expected)
    {
        IniFile ini = IniFile.Read(new StringReader("[Bridge]\n" + line));
        BridgeSettings settings = BridgeSettings.Read(ini, "default", text => "/mod/" + text);

        Assert.Equal(Read(""), settings);
        Assert.Contains(expected, Assert.Single(ini.Complaints), StringComparison.Ordinal);
    }

    [Fact]
    public void Bridge_that_is_off_cannot_be_opened() =>
        Assert.Throws<InvalidOperationException>(() => Read("[Bridge]\nKind = Off").Open());

    private static BridgeSettings Read(string ini) =>
        BridgeSettings.Read(IniFile.Read(new StringReader(ini)), "default", text => "/mod/" + text);
}
