using System;
using System.Buffers.Text;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Reports;

/// <summary>Writes a session as one page that needs nothing beside it, unless it is asked to link its images: frames with their boxes, and figures of the whole.</summary>
public sealed class ReportWriter
{
    /// <summary>Name of a session's report when none is given.</summary>
    public const string FileName = "report.html";

    private readonly SessionReader _session;
    private readonly ReportLimits _limits;

    /// <summary>Takes what to report on.</summary>
    public ReportWriter(SessionReader session, ReportLimits? limits = null)
    {
        _session = session;
        _limits = limits ?? new ReportLimits();
    }

    /// <summary>Writes the report under a temporary name and then gives it its own, in place of an older one.</summary>
    /// <param name="path">Where it goes.</param>
    /// <returns>How many frames it shows.</returns>
    /// <exception cref="DatasetFormatException">The session cannot be read.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public int Write(string path)
    {
        string temporary = path + ".tmp";
        try
        {
            int shown;
            using (FileStream stream = File.Create(temporary))
            {
                shown = Write(stream, Path.GetDirectoryName(Path.GetFullPath(path))!);
            }

            File.Move(temporary, path, overwrite: true);
            return shown;
        }
        catch
        {
            File.Delete(temporary);
            throw;
        }
    }

    private int Write(FileStream stream, string folder)
    {
        SessionInfo info = _session.ReadInfo();
        SessionStatistics statistics = SessionStatistics.Of(_session.ReadLabels());
        IReadOnlyList<int> chosen = Choose(statistics.Frames);
        List<FrameLabel> frames = [.. LabelsAt(chosen)];

        WriteText(stream, $"""
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <title>Harvest report</title>
            <style>
            {Asset("report.css")}</style>
            </head>
            <body>
            {Asset("report.html")}<script type="application/json" id="data">
            """);
        stream.Write(ReportData.Write(Path.GetFileName(Path.GetFullPath(_session.Folder)), info, statistics, frames));
        WriteText(stream, "</script>\n");
        for (int i = 0; i < frames.Count; i++)
        {
            string image = _session.PathOf(frames[i].Image);
            if (_limits.LinksImages)
            {
                WriteText(stream, $"<script type=\"text/plain\" id=\"image-{i}\" data-href=\"{Address(folder, image)}\"></script>\n");
            }
            else
            {
                WriteImage(stream, i, image);
            }
        }

        WriteText(stream, $"<script>\n{Asset("report.js")}</script>\n</body>\n</html>\n");
        return frames.Count;
    }

    private IReadOnlyList<int> Choose(int count)
    {
        IReadOnlyList<int> chosen = EvenSelection.Of(count, _limits.Frames);
        if (_limits.LinksImages)
        {
            return chosen;
        }

        long bytes = LabelsAt(chosen).Sum(label => new FileInfo(_session.PathOf(label.Image)).Length);
        return bytes <= _limits.ImageBytes
            ? chosen
            : EvenSelection.Of(count, (int)Math.Max(1, chosen.Count * _limits.ImageBytes / bytes));
    }

    private IEnumerable<FrameLabel> LabelsAt(IReadOnlyList<int> indices)
    {
        int next = 0;
        int index = 0;
        foreach (FrameLabel label in _session.ReadLabels())
        {
            if (next < indices.Count && indices[next] == index++)
            {
                next++;
                yield return label;
            }
        }
    }

    private static void WriteImage(FileStream stream, int index, string path)
    {
        byte[] bytes = File.ReadAllBytes(path);
        byte[] text = new byte[Base64.GetMaxEncodedToUtf8Length(bytes.Length)];
        Base64.EncodeToUtf8(bytes, text, out _, out int written);
        WriteText(stream, $"<script type=\"text/plain\" id=\"image-{index}\" data-type=\"{ImageHeader.Read(path).MediaType}\">");
        stream.Write(text.AsSpan(0, written));
        WriteText(stream, "</script>\n");
    }

    /// <summary>A file as a page in a folder names it.</summary>
    private static string Address(string folder, string file)
    {
        string path = Path.GetRelativePath(folder, Path.GetFullPath(file));
        return Path.IsPathRooted(path)
            ? WebUtility.HtmlEncode(new Uri(path).AbsoluteUri)
            : string.Join('/', path.Split(Path.DirectorySeparatorChar).Select(Uri.EscapeDataString));
    }

    private static string Asset(string name)
    {
        using Stream stream = typeof(ReportWriter).Assembly.GetManifestResourceStream($"Harvester.Datasets.Reports.Assets.{name}")!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }

    private static void WriteText(FileStream stream, string text) => stream.Write(Encoding.UTF8.GetBytes(text.ReplaceLineEndings("\n")));
}
