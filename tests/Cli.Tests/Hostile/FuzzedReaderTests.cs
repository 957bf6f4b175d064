using System.Collections.Concurrent;
using System.Globalization;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>
/// Thousands of damaged files of every kind are read or refused by the types that read them, without any other exception. Each case has a
/// seed of its own, so that it can be repeated alone. HARVESTER_FUZZ_CASES sets the cases of a kind, HARVESTER_FUZZ_SEED the seed.
/// <see cref="FuzzTests"/> runs whole commands, of which a case takes longer. What fails is kept in Hostile/Inputs.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class FuzzedReaderTests(FuzzReaderCorpus corpus, ITestOutputHelper output) : IClassFixture<FuzzReaderCorpus>
{
    private const int Cases = 3_000;
    private const int CasesInCi = 140;
    private const int DefaultSeed = 20260101;

    public static TheoryData<string> Kinds => FuzzKind.Names;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Damaged_file_is_read_or_refused(string name)
    {
        FuzzKind kind = FuzzKind.Of(name);
        int cases = TestSetting.Number("HARVESTER_FUZZ_CASES", ProofSize.Of(CasesInCi, Cases));
        int seed = TestSetting.Number("HARVESTER_FUZZ_SEED", DefaultSeed);
        byte[] sound = corpus.Sound(kind);
        TimeSpan before = Environment.CpuUsage.TotalTime;
        var faults = new ConcurrentDictionary<string, byte[]>(StringComparer.Ordinal);
        int workers = Environment.ProcessorCount;
        Parallel.For(
            0,
            workers,
            new ParallelOptions { MaxDegreeOfParallelism = workers },
            worker =>
            {
                string folder = corpus.FolderOf(worker);
                string file = Path.Combine(folder, kind.File);
                for (int i = worker; i < cases; i += workers)
                {
                    byte[] damaged = Mutation.Of(sound, new Random(unchecked((seed * 31) + i)));
                    File.Delete(file);
                    File.WriteAllBytes(file, damaged);
                    if (kind.FaultOf(folder) is { } fault)
                    {
                        faults.TryAdd(fault, damaged);
                    }
                }

                File.WriteAllBytes(file, sound);
            }
        );

        double seconds = (Environment.CpuUsage.TotalTime - before).TotalSeconds;
        output.WriteLine(
            string.Create(
                CultureInfo.InvariantCulture,
                $"{name}: seed {seed}, {cases} cases of {sound.Length} bytes, {seconds:0.0} s of processor time"
            )
        );
        string kept = Keep(name, faults);
        Assert.True(
            faults.IsEmpty,
            $"{string.Join('\n', faults.Keys)}\nThe inputs are kept in {kept}; move them to tests/Cli.Tests/Hostile/Inputs/{name}."
        );
    }

    private static string Keep(string name, ConcurrentDictionary<string, byte[]> faults)
    {
        string folder = Path.Combine(Path.GetTempPath(), "harvester-fuzz", name);
        foreach ((int index, byte[] content) in faults.Values.Index())
        {
            Directory.CreateDirectory(folder);
            File.WriteAllBytes(Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $"reader-{index}")), content);
        }

        return folder;
    }
}
