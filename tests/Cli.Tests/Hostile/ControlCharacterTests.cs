using System.Security.Cryptography;
using System.Text;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Characters that a terminal would obey, in names that commands print.</summary>
public sealed class ControlCharacterTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private const char Escape = '\u001b';

    private readonly HostileSession _hostile = new(session);

    public void Dispose() => _hostile.Dispose();

    [Theory]
    [InlineData("validate", "SESSION")]
    [InlineData("repair", "SESSION", "--out", "OUT")]
    public void Name_in_a_manifest_is_printed_without_them(params string[] command)
    {
        string entry = $$"""{"path":"x\u001b[2J","bytes":1,"sha256":"{{new string('0', 64)}}" """.TrimEnd();
        string check = Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(entry)))[..16];
        File.AppendAllText(_hostile.In("manifest.jsonl"), $"{entry},\"check\":\"{check}\"}}\n");

        CliRun run = HostileSession.Run([
            .. command.Select(word =>
                word.Replace("SESSION", _hostile.Folder, StringComparison.Ordinal)
                    .Replace("OUT", _hostile.PathOf("out"), StringComparison.Ordinal)
            ),
        ]);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("x[2J: ", run.Out, StringComparison.Ordinal);
        Assert.DoesNotContain(Escape, run.Out);
    }
}
