using System.Net;
using System.Security.Cryptography;
using Harvester.Reports.Viewing;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.Extensions.DependencyInjection;

namespace Harvester.Viewer;

/// <summary>
/// Serves sessions on the loopback address to clients that know a random token, which is part of the address. It only reads.
/// </summary>
public sealed class ViewServer : IAsyncDisposable
{
    private const int TokenBytes = 24;

    private static readonly TimeSpan StopPatience = TimeSpan.FromSeconds(1);

    private readonly WebApplication _application;

    private ViewServer(WebApplication application, Uri address)
    {
        _application = application;
        Address = address;
    }

    /// <summary>Address of the first page, with the token.</summary>
    public Uri Address { get; }

    /// <summary>Starts to serve.</summary>
    /// <param name="views">The sessions; the caller closes them after the server.</param>
    /// <param name="port">The port; 0 for a free one.</param>
    /// <param name="cancellation">Gives up starting.</param>
    /// <exception cref="IOException">The port cannot be used; the message says why.</exception>
    public static async Task<ViewServer> StartAsync(IReadOnlyList<SessionView> views, int port, CancellationToken cancellation = default)
    {
        string token = Convert.ToHexStringLower(RandomNumberGenerator.GetBytes(TokenBytes));
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder
            .WebHost.UseKestrelCore()
            .ConfigureKestrel(options =>
            {
                options.AddServerHeader = false;
                options.Listen(IPAddress.Loopback, port);
            });
        WebApplication application = builder.Build();
        var access = new AccessCheck(token);
        var resources = new ViewResources(views);
        application.Run(context => access.Admits(context, out string[] path) ? resources.AnswerAsync(context, path) : Task.CompletedTask);
        try
        {
            await application.StartAsync(cancellation).ConfigureAwait(false);
        }
        catch (Exception e) when (e is IOException or System.Net.Sockets.SocketException)
        {
            await application.DisposeAsync().ConfigureAwait(false);
            throw new IOException(
                e.InnerException is AddressInUseException
                    ? $"Port {port} is in use. Choose another port, or omit --port for a free one."
                    : $"Port {port} cannot be used: {e.Message} Choose another port, or omit --port for a free one.",
                e
            );
        }

        var bound = new Uri(application.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>()!.Addresses.Single());
        access.Port = bound.Port;
        return new ViewServer(application, new Uri(bound, $"/{token}/{(views.Count == 1 ? "0/" : "")}"));
    }

    /// <inheritdoc/>
    public async ValueTask DisposeAsync()
    {
        using var patience = new CancellationTokenSource(StopPatience);
        await _application.StopAsync(patience.Token).ConfigureAwait(false);
        await _application.DisposeAsync().ConfigureAwait(false);
    }
}
