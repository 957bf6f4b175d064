using System.Text.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The tables of a scene's objects. An object that is annotated again after a gap continues its chain.</summary>
internal static class NuScenesObjectTables
{
    /// <summary>A field that nuScenes does not have: the number of LiDAR points whose rays met the object.</summary>
    public const string Hits = "num_lidar_hits";

    /// <summary>The objects.</summary>
    public static IEnumerable<Action<Utf8JsonWriter>> Instances(NuScenesScene scene) =>
        Sightings(scene)
            .GroupBy(sighting => sighting.Seen.Object.Id)
            .OrderBy(group => group.Key)
            .Select(group =>
                (Action<Utf8JsonWriter>)(
                    json =>
                    {
                        json.WriteString("token", scene.InstanceTokenOf(group.Key));
                        json.WriteString("category_token", NuScenesTables.CategoryToken(group.First().Seen.Object.Category));
                        json.WriteNumber("nbr_annotations", group.Count());
                        json.Link("first_annotation_token", scene.AnnotationTokenOf(group.Key, group.First().Moment));
                        json.Link("last_annotation_token", scene.AnnotationTokenOf(group.Key, group.Last().Moment));
                    }
                )
            );

    /// <summary>The objects at the samples.</summary>
    public static IEnumerable<Action<Utf8JsonWriter>> Annotations(NuScenesScene scene)
    {
        (int Moment, NuScenesSighting Seen)[] all = [.. Sightings(scene)];
        ILookup<int, int> moments = all.ToLookup(sighting => sighting.Seen.Object.Id, sighting => sighting.Moment);
        HashSet<int> movers = [.. all.Where(sighting => sighting.Seen.IsMoving).Select(sighting => sighting.Seen.Object.Id)];
        foreach ((int moment, NuScenesSighting seen) in all)
        {
            NuScenesObject item = seen.Object;
            int[] chain = [.. moments[item.Id]];
            int index = Array.IndexOf(chain, moment);
            yield return json =>
            {
                json.WriteString("token", scene.AnnotationTokenOf(item.Id, moment));
                json.WriteString("sample_token", scene.SampleTokenOf(moment));
                json.WriteString("instance_token", scene.InstanceTokenOf(item.Id));
                json.WriteString("visibility_token", NuScenesClasses.VisibilityOf(seen.VisibleFraction));
                json.WriteStartArray("attribute_tokens");
                if (NuScenesClasses.AttributeOf(item.Category, seen.IsMoving, movers.Contains(item.Id), item.HasRider) is { } attribute)
                {
                    json.WriteStringValue(NuScenesTables.AttributeToken(attribute));
                }

                json.WriteEndArray();
                NuScenesDataTables.WriteFields(json, item.Box, scene.Area.Offset);
                json.Link("prev", index > 0 ? scene.AnnotationTokenOf(item.Id, chain[index - 1]) : null);
                json.Link("next", index + 1 < chain.Length ? scene.AnnotationTokenOf(item.Id, chain[index + 1]) : null);
                json.WriteNumber("num_lidar_pts", item.Points);
                json.WriteNumber("num_radar_pts", 0);
                json.WriteNumber(Hits, item.Hits);
                NuScenesEvent.WriteTokens(json, scene.EventsOf(moment), item.Id);
            };
        }
    }

    private static IEnumerable<(int Moment, NuScenesSighting Seen)> Sightings(NuScenesScene scene) =>
        scene.Annotated().SelectMany(sample => sample.Objects.Select(item => (sample.Moment, item)));
}
