namespace Harvester.Sessions.SelfTests;

/// <summary>The result of one check.</summary>
/// <param name="Check">The check, one of <see cref="SelfTestChecks"/>.</param>
/// <param name="Verdict">What it found.</param>
/// <param name="Sentence">The finding with its figures, one sentence.</param>
public sealed record SelfTestLine(string Check, SelfTestVerdict Verdict, string Sentence);
