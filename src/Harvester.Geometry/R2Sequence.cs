namespace Harvester.Geometry;

/// <summary>
/// Steps of the R2 sequence (Roberts): the fractional parts of their multiples are spread evenly over the unit square. They are the first
/// two powers of the inverse of the plastic number 1.3247...
/// </summary>
internal static class R2Sequence
{
    /// <summary>Step along the first axis: the inverse of the plastic number.</summary>
    public const double First = 0.7548776662466927;

    /// <summary>Step along the second axis: the square of the first step.</summary>
    public const double Second = 0.5698402909980532;
}
