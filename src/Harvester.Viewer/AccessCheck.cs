using System.Security.Cryptography;
using System.Text;
using Microsoft.AspNetCore.Http;

namespace Harvester.Viewer;

/// <summary>
/// Decides which requests are answered: those that name this machine as host, so that no page of another site can reach the server
/// through a name that resolves to this machine, and whose path begins with the token.
/// </summary>
/// <param name="token">The token.</param>
internal sealed class AccessCheck(string token)
{
    /// <summary>The port of an address and of a Host header that name none (RFC 9110, section 4.2.1).</summary>
    private const int DefaultPort = 80;

    private readonly byte[] _token = Encoding.UTF8.GetBytes(token);

    /// <summary>The port that is served; until it is set, nothing is admitted.</summary>
    public int? Port { get; set; }

    /// <summary>Whether a request is admitted; if it is not, the response is complete.</summary>
    /// <param name="context">The request.</param>
    /// <param name="path">The parts of the path after the token.</param>
    public bool Admits(HttpContext context, out string[] path)
    {
        SetHeaders(context.Response.Headers);
        path = [];
        HttpRequest request = context.Request;
        if ((request.Host.Port ?? DefaultPort) != Port || request.Host.Host is not ("127.0.0.1" or "localhost"))
        {
            context.Response.StatusCode = StatusCodes.Status403Forbidden;
            return false;
        }

        string[] parts = (request.Path.Value ?? "/").Split('/');
        if (parts.Length < 2 || !CryptographicOperations.FixedTimeEquals(Encoding.UTF8.GetBytes(parts[1]), _token))
        {
            context.Response.StatusCode = StatusCodes.Status404NotFound;
            return false;
        }

        if (!HttpMethods.IsGet(request.Method))
        {
            context.Response.StatusCode = StatusCodes.Status405MethodNotAllowed;
            return false;
        }

        path = parts[2..];
        return true;
    }

    private static void SetHeaders(IHeaderDictionary headers)
    {
        headers.CacheControl = "no-store";
        headers.XContentTypeOptions = "nosniff";
        headers.ContentSecurityPolicy = "default-src 'none'; frame-ancestors 'none'";
        headers["Referrer-Policy"] = "no-referrer";
        headers["Cross-Origin-Resource-Policy"] = "same-origin";
        headers["Cross-Origin-Opener-Policy"] = "same-origin";
    }
}
