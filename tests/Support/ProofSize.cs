namespace Harvester.TestSupport;

/// <summary>
/// How many cases a heavier proof has. CI tries a share of them, in the time that it has; HARVESTER_PROOFS=full tries all, which is where
/// the figures of the documentation come from.
/// </summary>
internal static class ProofSize
{
    private static bool IsFull => Environment.GetEnvironmentVariable("HARVESTER_PROOFS") == "full";

    /// <summary>A number of cases.</summary>
    /// <param name="inCi">What CI tries.</param>
    /// <param name="full">All.</param>
    public static int Of(int inCi, int full) => IsFull ? full : inCi;

    /// <summary>Cases by name: all, or those that CI tries.</summary>
    /// <param name="inCi">What CI tries.</param>
    /// <param name="full">All.</param>
    public static T[] Of<T>(T[] inCi, T[] full) => IsFull ? full : inCi;
}
