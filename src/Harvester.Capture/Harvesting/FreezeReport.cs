using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>The freeze methods that were tried at the start of a harvest, and the one that is used.</summary>
public sealed class FreezeReport
{
    /// <summary>Factor by which one image must change less than another to count as calmer.</summary>
    private const double CalmerFactor = 2;

    /// <summary>An invisible mean difference, of 255: images that change less are equally calm.</summary>
    private const double CalmPictureChange = 0.1;

    private FreezeReport(FreezeFinding used, IReadOnlyList<FreezeFinding> findings)
    {
        Used = used;
        Findings = findings;
    }

    /// <summary>The finding about the method that is used.</summary>
    public FreezeFinding Used { get; }

    /// <summary>The method that is used.</summary>
    public FreezeMethod Method => Used.Method;

    /// <summary>All findings, in the order of the trials.</summary>
    public IReadOnlyList<FreezeFinding> Findings { get; }

    /// <summary>Whether something moved before every trial, so that the findings are conclusive.</summary>
    public bool IsConclusive => Findings.All(finding => finding.SawMovement);

    /// <summary>
    /// Chooses the better method. In this order of priority it holds the world still, lets the camera move, holds weather and time of day,
    /// shows a calmer image, and takes fewer ticks; of equal methods the one tried first is chosen.
    /// </summary>
    /// <param name="findings">One finding for each method, at least one.</param>
    /// <exception cref="ArgumentException">There is no finding.</exception>
    public static FreezeReport Of(IReadOnlyList<FreezeFinding> findings)
    {
        if (findings is null || findings.Count == 0)
        {
            throw new ArgumentException("At least one finding is needed.", nameof(findings));
        }

        return new FreezeReport(findings.Aggregate((best, next) => Compare(next, best) > 0 ? next : best), findings);
    }

    /// <summary>The findings and the choice in one line, for a log.</summary>
    public override string ToString() => $"{string.Join("; ", Findings)}; {Method} is used.";

    /// <summary>Greater than 0 if the first method is better.</summary>
    private static int Compare(FreezeFinding a, FreezeFinding b) =>
        new[]
        {
            a.HoldsWorld.CompareTo(b.HoldsWorld),
            (a.MovesCamera ?? false).CompareTo(b.MovesCamera ?? false),
            (a.HoldsEnvironment ?? false).CompareTo(b.HoldsEnvironment ?? false),
            IsCalmer(a, b).CompareTo(IsCalmer(b, a)),
            (b.SettleTicks ?? 0).CompareTo(a.SettleTicks ?? 0),
        }.FirstOrDefault(order => order != 0);

    private static bool IsCalmer(FreezeFinding a, FreezeFinding b) =>
        a.PictureChange is { } change && b.PictureChange is { } other && other > CalmPictureChange && change * CalmerFactor < other;
}
