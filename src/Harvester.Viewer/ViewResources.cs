using System.Globalization;
using Harvester.Reports.Viewing;
using Harvester.Sessions.Reading.Files;
using Microsoft.AspNetCore.Http;

namespace Harvester.Viewer;

/// <summary>
/// All that the server has, by the number of a session and of a frame, block or frame number. No part of a path is ever the name of a file.
/// </summary>
/// <param name="views">The sessions.</param>
internal sealed class ViewResources(IReadOnlyList<SessionView> views)
{
    private const string Json = "application/json";
    private const string Binary = "application/octet-stream";
    private const string Html = "text/html; charset=utf-8";

    /// <summary>Answers a request.</summary>
    /// <param name="context">The request.</param>
    /// <param name="path">The parts of its path.</param>
    public async Task AnswerAsync(HttpContext context, string[] path)
    {
        HttpResponse response = context.Response;
        byte[] content;
        try
        {
            if (Find(response, path) is not { } found)
            {
                response.StatusCode = StatusCodes.Status404NotFound;
                return;
            }

            content = found;
        }
        catch (ArgumentOutOfRangeException)
        {
            response.StatusCode = StatusCodes.Status404NotFound;
            return;
        }
        catch (Exception e) when (e is DatasetFormatException or IOException or UnauthorizedAccessException)
        {
            response.StatusCode = e is FileNotFoundException or DirectoryNotFoundException
                ? StatusCodes.Status404NotFound
                : StatusCodes.Status422UnprocessableEntity;
            response.ContentType = "text/plain; charset=utf-8";
            await response.WriteAsync(e.Message, context.RequestAborted).ConfigureAwait(false);
            return;
        }

        response.ContentLength = content.Length;
        await response.Body.WriteAsync(content, context.RequestAborted).ConfigureAwait(false);
    }

    /// <summary>Sets the type of a resource and returns its content; null if there is none.</summary>
    private byte[]? Find(HttpResponse response, string[] path)
    {
        switch (path)
        {
            case [""]:
                return Page(response, stream => ChooserPage.Write(stream, views));
            case [var session, ""] when ViewOf(session) is { } view:
                return Page(response, view.WritePage);
            case [var session, "state"] when ViewOf(session) is { } view:
                response.ContentType = Json;
                return view.State();
            case [var session, "figures"] when ViewOf(session) is { } view:
                response.ContentType = Json;
                return view.Figures();
            case [var session, var kind, var number] when ViewOf(session) is { } view && NumberOf(number) is { } index:
                return Find(response, view, kind, index);
            default:
                return null;
        }
    }

    private static byte[]? Find(HttpResponse response, SessionView view, string kind, int number)
    {
        response.ContentType = kind is "frame" or "objects" or "index" ? Json : Binary;
        switch (kind)
        {
            case "frame":
                return view.Frame(number);
            case "image":
                return Raster(response, view, number, FrameRaster.Image);
            case "mask":
                return Raster(response, view, number, FrameRaster.Mask);
            case "depth":
                return Raster(response, view, number, FrameRaster.Depth);
            case "points":
                return view.Points(number);
            case "block":
                return view.Block(number);
            case "objects":
                return view.ObjectsOf(number);
            case "index":
                return System.Text.Encoding.UTF8.GetBytes(view.IndexOf(number).ToString(CultureInfo.InvariantCulture));
            default:
                return null;
        }
    }

    private static byte[]? Raster(HttpResponse response, SessionView view, int number, FrameRaster raster)
    {
        if (view.Raster(number, raster) is not { } file)
        {
            return null;
        }

        response.ContentType = file.MediaType;
        return file.Content;
    }

    private static byte[] Page(HttpResponse response, Func<Stream, string> write)
    {
        using var page = new MemoryStream();
        response.ContentType = Html;
        response.Headers.ContentSecurityPolicy = write(page);
        return page.ToArray();
    }

    private SessionView? ViewOf(string text) => NumberOf(text) is { } number && number < views.Count ? views[number] : null;

    private static int? NumberOf(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : null;
}
