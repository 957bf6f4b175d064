using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the depth maps of a frame against their label and each other.</summary>
internal static class DepthCheck
{
    public static IEnumerable<string> Problems(DepthLabel depth, Func<string, InstanceMap> read)
    {
        int measured = read(depth.Sparse).Ids.Count(static value => value != 0);
        if (measured != depth.MeasuredPixels)
        {
            yield return $"depth map '{depth.Sparse}' has {measured} measured pixels, but its label says {depth.MeasuredPixels}.";
        }

        if (
            depth is { Completed: { } completed, Error: { } error }
            && read(completed).Ids.Zip(read(error).Ids).Count(static pair => (pair.First == 0) != (pair.Second == 0)) is > 0 and var wrong
        )
        {
            yield return $"depth map '{error}' must have an error for each pixel with a depth of '{completed}'; {wrong} pixels differ.";
        }

        if (depth.Completed is null != depth.Error is null)
        {
            yield return "depth has only one of completed and error.";
        }
    }
}
