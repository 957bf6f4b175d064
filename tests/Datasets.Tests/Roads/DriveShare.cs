using System.Globalization;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>The fraction of some samples of a drive that were matched correctly.</summary>
internal readonly record struct DriveShare(int Samples, int Right)
{
    public double RightFraction => (double)Right / Samples;

    public DriveShare With(bool isRight) => new(Samples + 1, Right + (isRight ? 1 : 0));

    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{100 * RightFraction:0.000} % of {Samples} right");
}
