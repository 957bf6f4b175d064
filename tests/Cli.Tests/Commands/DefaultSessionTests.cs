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

    public DefaultSessionTests() => CliRun.Of(
        "harvest", "--out", _folder.PathOf("session"), "--frames", "2", "--seed", "3", "--size", "64x48", "--no-report").AssertDone();

    public void Dispose() => _folder.Dispose();

    [LinuxX64Theory]
    [InlineData("labels.jsonl", "e0c786d865a53756dbdb5604f45eeb42e93decaf3d732fa992edca1e6f54fa17")]
    [InlineData("session.json", "3faf46e08c08dca1b046446b1116da740ee160d2f97990837ecfa762f58d40b8")]
    [InlineData("frames/00000000.png", "4355505fa9a55fd72346c7430605a3c509e4b302ff2a38538552ce551a0455c1")]
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
        return file != "session.json" ? bytes : Encoding.UTF8.GetBytes(string.Join('\n', Encoding.UTF8.GetString(bytes).Split('\n')
            .Where(line => !line.Contains("\"tool\":", StringComparison.Ordinal)
                && !line.Contains("\"captureVersion\":", StringComparison.Ordinal))));
    }
}
