using Harvester.Exports.Checks;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.Flow;

/// <summary>Checks exported pairs of images and their flow: all files are there, of one size, and say the same of each pixel.</summary>
internal static class FlowExportCheck
{
    private static readonly string[] Extensions = [".png", ".bmp", ".jpg"];

    public static IEnumerable<SessionProblem> KittiProblems(DatasetContent dataset) => Problems(dataset, FlowLayout.Kitti);

    public static IEnumerable<SessionProblem> MiddleburyProblems(DatasetContent dataset) => Problems(dataset, FlowLayout.Middlebury);

    private static IEnumerable<SessionProblem> Problems(DatasetContent dataset, FlowLayout layout)
    {
        var frames = new Dictionary<string, int>(StringComparer.Ordinal);
        foreach (string name in layout.NamesIn(dataset))
        {
            frames[name] = 1;
            foreach (SessionProblem problem in PairProblems(dataset, layout, name))
            {
                yield return problem;
            }
        }

        foreach (SessionProblem problem in SplitLists.Problems(dataset, FlowLayout.ListOf, frames))
        {
            yield return problem;
        }
    }

    private static IEnumerable<SessionProblem> PairProblems(DatasetContent dataset, FlowLayout layout, string name)
    {
        var sizes = new List<ImageSize>();
        foreach (string image in (string[])[layout.First(name), layout.Second(name)])
        {
            string? file = Extensions.Select(extension => image + extension).FirstOrDefault(dataset.Has);
            if (file is null)
            {
                yield return new SessionProblem(image, null, "the image is missing.");
            }
            else if (dataset.Header(file) is { } header)
            {
                sizes.Add(header.Size);
            }
        }

        if (sizes.Count != 2)
        {
            yield break;
        }

        if (sizes[0] != sizes[1])
        {
            yield return new SessionProblem(layout.Second(name), null, "its size is not that of the first image of its pair.");
            yield break;
        }

        ushort[]? all = null;
        foreach ((Func<string, string> path, FlowMapKind kind) in layout.Maps)
        {
            (ushort[]? vectors, string? problem) = Read(dataset, path(name), kind, sizes[0]);
            problem ??=
                kind == FlowMapKind.Visible && all is not null && !IsPartOf(vectors!, all) ? "it has a flow that flow_occ has not." : null;
            all = kind == FlowMapKind.All ? vectors : all;
            if (problem is not null)
            {
                yield return new SessionProblem(path(name), null, problem);
            }
        }
    }

    /// <summary>Reads a map; the numbers are those of a map of KITTI's flow.</summary>
    private static (ushort[]? Vectors, string? Problem) Read(DatasetContent dataset, string file, FlowMapKind kind, ImageSize size)
    {
        if (!dataset.Has(file))
        {
            return (null, "it is missing, but its images exist.");
        }

        try
        {
            if (kind == FlowMapKind.Float)
            {
                return (null, FloFile.ProblemOf(InputFile.ReadAllBytes(dataset.PathOf(file), FloFile.LengthOf(size)), size));
            }

            if (kind is FlowMapKind.Moved or FlowMapKind.VisibleMask)
            {
                InstanceMap mask = PngDecoder.ReadLabelMap(dataset.PathOf(file));
                int greatest = kind == FlowMapKind.Moved ? 1 : byte.MaxValue;
                return mask.Image != size ? (null, "its size is not that of its images.")
                    : Array.Exists(mask.Ids, value => value != 0 && value != greatest)
                        ? (null, $"it has numbers other than 0 and {greatest}.")
                    : (null, null);
            }

            ushort[] vectors = PngDecoder.ReadDeepColour(dataset.PathOf(file));
            return vectors.Length != 3 * size.PixelCount ? (null, "its size is not that of its images.")
                : !AreKitti(vectors) ? (null, "it has a pixel that is neither a flow with 1 in blue nor 0 in all colours.")
                : (vectors, null);
        }
        catch (DatasetFormatException e)
        {
            return (null, e.Message);
        }
    }

    private static bool AreKitti(ushort[] vectors)
    {
        for (int at = 0; at < vectors.Length; at += 3)
        {
            if (vectors[at + 2] > 1 || (vectors[at + 2] == 0 && (vectors[at] != 0 || vectors[at + 1] != 0)))
            {
                return false;
            }
        }

        return true;
    }

    private static bool IsPartOf(ushort[]? part, ushort[] all)
    {
        for (int at = 0; part is not null && at < part.Length; at += 3)
        {
            if (part[at + 2] == 1 && !part.AsSpan(at, 3).SequenceEqual(all.AsSpan(at, 3)))
            {
                return false;
            }
        }

        return true;
    }
}
