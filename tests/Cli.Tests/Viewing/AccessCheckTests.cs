using Harvester.Viewer;
using Microsoft.AspNetCore.Http;

namespace Harvester.Cli.Tests.Viewing;

public sealed class AccessCheckTests
{
    /// <summary>A browser leaves the default port out of the Host header.</summary>
    [Theory]
    [InlineData(80, "127.0.0.1", true)]
    [InlineData(80, "localhost", true)]
    [InlineData(80, "localhost:80", true)]
    [InlineData(80, "localhost:8080", false)]
    [InlineData(80, "rebound.example", false)]
    [InlineData(8080, "localhost", false)]
    public void Host_without_port_has_port_80(int port, string host, bool expected)
    {
        var access = new AccessCheck("token") { Port = port };
        var context = new DefaultHttpContext();
        context.Request.Method = "GET";
        context.Request.Host = new HostString(host);
        context.Request.Path = "/token/0/";

        Assert.Equal(expected, access.Admits(context, out _));
    }

    [Fact]
    public void Nothing_is_admitted_before_the_port_is_set()
    {
        var context = new DefaultHttpContext();
        context.Request.Method = "GET";
        context.Request.Host = new HostString("localhost");
        context.Request.Path = "/token/0/";

        Assert.False(new AccessCheck("token").Admits(context, out _));
    }
}
