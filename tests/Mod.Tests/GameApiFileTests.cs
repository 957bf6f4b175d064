namespace Harvester.Mod.Tests;

/// <summary>
/// Nightlies and the Enhanced fork call members obsolete that the mod needs for 3.6.0: built against such a dll, warnings are no errors.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class GameApiFileTests
{
    [Fact]
    public void Mod_builds_against_an_api_whose_members_are_all_obsolete()
    {
        using var build = new ModBuild();
        string api = build.PathOf("api/ScriptHookVDotNet3.dll");
        Directory.CreateDirectory(Path.GetDirectoryName(api)!);
        ObsoleteApi.Write(api);

        (int exitCode, string output) = build.Build("-p:GameApi=file", "-p:ScriptHookVDotNetDll=" + api);

        Assert.True(exitCode == 0, output);
        Assert.Contains("warning CS0618", output, StringComparison.Ordinal);
        Assert.Contains("warning CS0612", output, StringComparison.Ordinal);
        Assert.True(File.Exists(build.PathOf("artifacts/Release/scripts/GtaDataHarvester.dll")));
    }

    [Fact]
    public void Default_build_refuses_an_obsolete_member()
    {
        using var build = new ModBuild();
        string notification = build.PathOf("ref/ScriptHookVDotNet3/UI/Notification.cs");
        const string member = "public static int Show(";
        string source = File.ReadAllText(notification);
        Assert.Contains(member, source, StringComparison.Ordinal);
        File.WriteAllText(notification, source.Replace(member, "[System.Obsolete(\"Use another.\")] " + member, StringComparison.Ordinal));

        (int exitCode, string output) = build.Build("-p:GameApi=standin");

        Assert.NotEqual(0, exitCode);
        Assert.Contains("error CS0618", output, StringComparison.Ordinal);
    }

    [Fact]
    public void Missing_dll_is_reported_with_advice()
    {
        using var build = new ModBuild();

        (int exitCode, string output) = build.Build("-p:GameApi=file", "-p:ScriptHookVDotNetDll=nowhere.dll");

        Assert.NotEqual(0, exitCode);
        Assert.Contains(
            "No dll at 'nowhere.dll': say where ScriptHookVDotNet3.dll lies with -p:ScriptHookVDotNetDll=PATH.",
            output,
            StringComparison.Ordinal
        );
    }
}
