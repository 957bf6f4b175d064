using System.Security.Cryptography;
using System.Text;

namespace Harvester.Cli.Tests.Commands;

/// <summary>
/// The bytes of a session with a single camera, which rigs, depth and whatever else a harvest can be given must leave as they are. The
/// digests were recorded on Linux x64. An intended change of the simulated world, of its drawing or of the labels gives others: record them
/// then, with an entry in the changelog. On other systems the mathematical functions may round differently.
/// </summary>
public sealed class DefaultSessionTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public DefaultSessionTests() =>
        CliRun
            .Of("harvest", "--out", _folder.PathOf("session"), "--frames", "2", "--seed", "3", "--size", "64x48", "--no-report")
            .AssertDone();

    public void Dispose() => _folder.Dispose();

    [LinuxX64Theory]
    [InlineData("labels.jsonl", "32eae6da86c77540364e4f53f917f00e2defc85c6b4d46667488d6f106106fe5")]
    [InlineData("session.json", "8a9773ffb65713c05f9780d24c40b20779ad40942c8615cdd433b75fb2fe1ef6")]
    [InlineData("frames/00000000.png", "064bfbd72521c5606e24ffb729ccfae39b356b24474cfc2616daf6ba0d5c5206")]
    [Trait("Category", "Heavy")]
    public void Bytes_of_a_default_session_stay_what_they_are(string file, string digest) =>
        Assert.Equal(digest, Convert.ToHexStringLower(SHA256.HashData(WithoutVersion(file))));

    [Fact]
    public void Default_session_has_no_field_of_a_rig()
    {
        string[] fields = ["\"moment\"", "\"view\"", "\"lidar\"", "\"motion\"", "\"depth\"", "\"rig\""];
        string text = File.ReadAllText(_folder.PathOf("session/labels.jsonl")) + File.ReadAllText(_folder.PathOf("session/session.json"));

        Assert.All(fields, field => Assert.DoesNotContain(field, text, StringComparison.Ordinal));
    }

    /// <summary>The bytes of a file; the version of the program is left out, because a release changes it.</summary>
    private byte[] WithoutVersion(string file)
    {
        byte[] bytes = File.ReadAllBytes(_folder.PathOf("session/" + file));
        return file != "session.json"
            ? bytes
            : Encoding.UTF8.GetBytes(
                string.Join(
                    '\n',
                    Encoding
                        .UTF8.GetString(bytes)
                        .Split('\n')
                        .Where(line =>
                            !line.Contains("\"tool\":", StringComparison.Ordinal)
                            && !line.Contains("\"captureVersion\":", StringComparison.Ordinal)
                        )
                )
            );
    }
}
