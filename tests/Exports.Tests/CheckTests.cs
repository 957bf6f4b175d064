using System.Text.RegularExpressions;
using Harvester.Datasets.Files;
using Harvester.Exports.Validation;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>
/// Tests that damage an export of the simulated session in one place and see whether the format's check finds it, and where.
/// </summary>
[Collection(SimulatedSession.Collection)]
public abstract class CheckTests(SimulatedSession simulated, string format) : ExportTests
{
    private protected static readonly ExportOptions Copied = new() { Images = ImageTransfer.Copy };

    private protected static readonly ExportOptions TwoSplits = Copied with
    {
        Splits = new SplitPlan([new("train", 0.5), new("val", 0.5)], 1, 1),
    };

    private protected SimulatedSession Simulated => simulated;

    /// <summary>Exports; images are copies, as tests change them.</summary>
    private protected void Export(ExportOptions? options = null) => Folder.Export(format, simulated.OpenFor(format), options ?? Copied);

    /// <summary>Exports, damages a file and looks for the problem.</summary>
    private protected void AssertDamageIsFound(string file, string pattern, string replacement, string expected)
    {
        Export();
        Damage(file, pattern, replacement);
        AssertFound(expected);
    }

    /// <summary>Exports, takes a file away and looks for the problem.</summary>
    private protected void AssertLossIsFound(string file, string expected)
    {
        Export();
        Delete(file);
        AssertFound(expected);
    }

    /// <summary>Replaces what a pattern first finds in a file.</summary>
    private protected void Damage(string file, string pattern, string replacement)
    {
        string path = Folder.PathOf("out/" + file);
        string text = File.ReadAllText(path);
        string damaged = new Regex(pattern, RegexOptions.Multiline | RegexOptions.CultureInvariant).Replace(text, replacement, 1);
        Assert.NotEqual(text, damaged);
        File.WriteAllText(path, damaged);
    }

    /// <summary>Takes a file away.</summary>
    private protected void Delete(string file) => File.Delete(Existing(file));

    /// <summary>Puts a copy of a file beside it.</summary>
    private protected void Copy(string file, string to) => File.Copy(Existing(file), Folder.PathOf("out/" + to));

    /// <summary>Whether one of the problems that are found begins with a text.</summary>
    private protected void AssertFound(string expected)
    {
        string[] problems = Problems();
        Assert.True(
            problems.Any(problem => problem.StartsWith(expected, StringComparison.Ordinal)),
            $"Not found: {expected}\n{string.Join('\n', problems)}"
        );
    }

    private protected string[] Problems() =>
        [.. DatasetValidator.Validate(Folder.PathOf("out")).Problems.Select(problem => problem.ToString())];

    private string Existing(string file)
    {
        Assert.True(File.Exists(Folder.PathOf("out/" + file)), file);
        return Folder.PathOf("out/" + file);
    }
}
