using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Reports.Viewing;

/// <summary>What the viewer keeps of every label, to filter it.</summary>
/// <param name="Id">Id of the object.</param>
/// <param name="DistanceMetres">Distance.</param>
/// <param name="TruncatedFraction">Truncated fraction.</param>
/// <param name="OccludedFraction">Occluded fraction; NaN if unknown.</param>
/// <param name="Box">The 2D box, pixels.</param>
internal readonly record struct OverviewObject(ushort Id, float DistanceMetres, float TruncatedFraction, float OccludedFraction, Box2D Box)
{
    /// <summary>Its size in a block: seven values and the id.</summary>
    public const int Bytes = 7 * sizeof(float) + sizeof(ushort);

    /// <summary>Takes the numbers from a label.</summary>
    public static OverviewObject Of(ObjectLabel item) =>
        new(
            (ushort)item.Id,
            (float)item.DistanceMetres,
            (float)item.TruncatedFraction,
            (float)(item.OccludedFraction ?? double.NaN),
            item.Box2D
        );
}
