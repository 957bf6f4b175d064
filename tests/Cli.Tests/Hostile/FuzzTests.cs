using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>
/// Every kind of input file, damaged at random: a command reads it or refuses it with a documented code and one line, and never in another
/// way. HARVESTER_FUZZ_CASES sets the cases of a kind, HARVESTER_FUZZ_SEED the seed. What fails is kept in Hostile/Inputs, so that it is
/// tried ever after.
/// </summary>
public sealed class FuzzTests(FuzzCorpus corpus, ITestOutputHelper output) : IClassFixture<FuzzCorpus>
{
    private const int Cases = 40;
    private const int CasesInCi = 16;
    private const int DefaultSeed = 20260101;

    public static TheoryData<string> Kinds => FuzzKind.Names;

    public static TheoryData<string, string> KeptInputs
    {
        get
        {
            var inputs = new TheoryData<string, string>();
            string folder = Path.Combine(AppContext.BaseDirectory, "Hostile", "Inputs");
            foreach (string file in Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
            {
                inputs.Add(Path.GetFileName(Path.GetDirectoryName(file)!), Path.GetFileName(file));
            }

            return inputs;
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    [Trait("Category", "Heavy")]
    public void Damaged_file_is_read_or_refused_in_one_line(string name)
    {
        FuzzKind kind = FuzzKind.Of(name);
        int seed = TestSetting.Number("HARVESTER_FUZZ_SEED", DefaultSeed);
        int cases = TestSetting.Number("HARVESTER_FUZZ_CASES", ProofSize.Of(CasesInCi, Cases));
        output.WriteLine($"{name}: seed {seed}, {cases} cases");
        var random = new Random(seed);
        int refused = 0;
        var faults = new SortedDictionary<string, byte[]>(StringComparer.Ordinal);
        for (int i = 0; i < cases; i++)
        {
            byte[] content = Mutation.Of(corpus[kind], random);
            string command = kind.Commands[i % kind.Commands.Length];
            CliRun run = corpus.Run(kind, content, command);
            refused += run.ExitCode == ExitCode.Done ? 0 : 1;
            if ((FaultOf(run) ?? corpus.LeftBy(run, command)) is { } fault)
            {
                faults.TryAdd($"{command}: {fault}", content);
            }
        }

        output.WriteLine($"{refused} refused");
        string kept = Keep(name, faults);
        Assert.True(
            faults.Count == 0,
            $"{string.Join('\n', faults.Keys)}\nThe inputs are kept in {kept}; move them to tests/Cli.Tests/Hostile/Inputs/{name}."
        );

        // Mutations that do no harm would prove nothing.
        Assert.True(refused > 0 || kind.IsReadWhatever);
    }

    [Theory]
    [MemberData(nameof(KeptInputs))]
    public void Input_that_failed_once_is_read_or_refused_in_one_line(string name, string file)
    {
        FuzzKind kind = FuzzKind.Of(name);
        byte[] content = File.ReadAllBytes(Path.Combine(AppContext.BaseDirectory, "Hostile", "Inputs", name, file));

        Assert.All(
            kind.Commands,
            command =>
            {
                CliRun run = corpus.Run(kind, content, command);
                Assert.Null(FaultOf(run) ?? corpus.LeftBy(run, command));
            }
        );
    }

    /// <summary>
    /// What of a run is against its promise; null for nothing. A file that is not good can be fault of the data, of the file system or of
    /// what the command line names.
    /// </summary>
    private static string? FaultOf(CliRun run) =>
        run.ExitCode is not (ExitCode.Done or ExitCode.BadData or ExitCode.Usage or ExitCode.InputOutput)
            ? $"exit code {run.ExitCode}: {run.Error}{Details(run.Error)}"
        : run.ExitCode != ExitCode.Done && run.Error.Length + run.Out.Length == 0 ? "nothing is said"
        : run.ExitCode == ExitCode.Done || LinesOf(run.Error) <= 1 ? null
        : $"more than one line: {run.Error}";

    // Notes on what was ignored may stand before the line of the error.
    private static int LinesOf(string error) =>
        error
            .Split('\n', StringSplitOptions.RemoveEmptyEntries)
            .Count(line =>
                !line.StartsWith("Note: ", StringComparison.Ordinal)
                && !line.Contains("the recording was interrupted", StringComparison.Ordinal)
            );

    private static string Details(string error) =>
        error.Split('\'') is [_, var file, ..] && File.Exists(file) ? File.ReadAllText(file) : "";

    private static string Keep(string name, SortedDictionary<string, byte[]> faults)
    {
        string folder = Path.Combine(Path.GetTempPath(), "harvester-fuzz", name);
        foreach ((byte[] content, int index) in faults.Values.Select((content, index) => (content, index)))
        {
            Directory.CreateDirectory(folder);
            File.WriteAllBytes(Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $"{index}")), content);
        }

        return folder;
    }
}
