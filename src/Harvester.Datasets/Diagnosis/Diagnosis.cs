namespace Harvester.Datasets.Diagnosis;

/// <summary>The problems that logs, a session or a self-test show.</summary>
/// <param name="Logs">The logs that were read; empty for a session and a self-test.</param>
/// <param name="Findings">The problems, the likeliest cause first; empty if there are none.</param>
public sealed record Diagnosis(IReadOnlyList<LogFile> Logs, IReadOnlyList<Finding> Findings)
{
    /// <summary>The self-test that was read; null for logs and sessions.</summary>
    public SelfTestFile? SelfTest { get; init; }

    /// <summary>What to do about a check of a self-test that is not good.</summary>
    public static string AdviceFor(string check) => SelfTestRules.AdviceFor(check);
}
