using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

public sealed class PlaythroughTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(8)]
    [Trait("Category", "Heavy")]
    public void Every_feature_works_with_bools_of_any_size(int bytes)
    {
        TestGame game;
        using (var driver = new ScriptDriver(Playthrough.Ini, made => made.BoolBytes = bytes, faces: LightTests.TableOfOne))
        {
            game = driver.Game;
            Playthrough.Of(driver);

            Assert.DoesNotContain(game.Notifications, message => message.Contains("failed", StringComparison.Ordinal));
            Assert.Contains(
                Directory.GetDirectories(driver.Output, "session*"),
                session => File.ReadAllLines(Path.Combine(session, "labels.jsonl")).Length > 0
            );
        }

        Assert.Empty(game.LeftBehind);
    }
}
