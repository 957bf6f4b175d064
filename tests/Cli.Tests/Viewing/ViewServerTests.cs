using System.Net;
using Harvester.Reports.Viewing;
using Harvester.Sessions.Reading;
using Harvester.Viewer;

namespace Harvester.Cli.Tests.Viewing;

public sealed class ViewServerTests : IAsyncLifetime, IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly HttpClient _client = new();
    private SessionView _view = null!;
    private ViewServer _server = null!;

    public async Task InitializeAsync()
    {
        SharedHarvest.CopyTo(_folder.PathOf("session"), "--frames", "1", "--size", "80x60", "--no-report");
        _view = new SessionView(new SessionReader(_folder.PathOf("session")));
        _server = await ViewServer.StartAsync([_view], port: 0);
    }

    public async Task DisposeAsync() => await _server.DisposeAsync();

    public void Dispose()
    {
        _view.Dispose();
        _client.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public async Task Image_is_the_file_of_the_session() =>
        Assert.Equal(
            await File.ReadAllBytesAsync(_folder.PathOf("session/frames/00000000.png")),
            await _client.GetByteArrayAsync(new Uri(_server.Address, "image/0"))
        );

    [Theory]
    [InlineData("/")]
    [InlineData("/0/")]
    [InlineData("/0123456789abcdef0123456789abcdef0123456789abcdef/0/")]
    public async Task Path_without_the_token_is_not_found(string path) =>
        Assert.Equal(HttpStatusCode.NotFound, await StatusAsync(new Uri(_server.Address, path), "127.0.0.1"));

    [Theory]
    [InlineData("127.0.0.1", HttpStatusCode.OK)]
    [InlineData("localhost", HttpStatusCode.OK)]
    [InlineData("rebound.example", HttpStatusCode.Forbidden)]
    [InlineData("127.0.0.1.example", HttpStatusCode.Forbidden)]
    [InlineData("192.168.0.1", HttpStatusCode.Forbidden)]
    public async Task Only_names_of_this_machine_are_answered(string host, HttpStatusCode expected) =>
        Assert.Equal(expected, await StatusAsync(_server.Address, host));

    [Theory]
    [InlineData("session.json")]
    [InlineData("image/1")]
    [InlineData("image/-1")]
    [InlineData("image/0.png")]
    [InlineData("image/..%2f..%2fsession.json")]
    [InlineData("scene/0")]
    [InlineData("mask/0")]
    public async Task What_is_no_resource_is_not_found(string path) =>
        Assert.Equal(HttpStatusCode.NotFound, await StatusAsync(new Uri(_server.Address, path), "127.0.0.1"));

    [Fact]
    public void Token_is_long_and_random()
    {
        string token = _server.Address.Segments[1];
        Assert.Equal(49, token.Length); // 24 bytes as hexadecimal digits, and the slash.
        Assert.True(token.Distinct().Count() > 5, token);
    }

    private async Task<HttpStatusCode> StatusAsync(Uri address, string host)
    {
        using var request = new HttpRequestMessage(HttpMethod.Get, address);
        request.Headers.Host = $"{host}:{_server.Address.Port}";
        using HttpResponseMessage response = await _client.SendAsync(request);
        return response.StatusCode;
    }
}
