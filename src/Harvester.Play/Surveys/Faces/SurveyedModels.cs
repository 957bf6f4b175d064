using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Surveys.Faces;

/// <summary>The game's models of signs and lights that a survey measures: those of a table, and those whose signs are unnamed.</summary>
public static class SurveyedModels
{
    private const string UnnamedModels = """
        prop_bus_stop_sign prop_consign_01a prop_consign_01b prop_consign_01c prop_consign_02a prop_rail_sign01 prop_rail_sign02
        prop_rail_sign03 prop_rail_sign04 prop_rail_sign05 prop_rail_sign06 prop_rail_signals01 prop_rail_signals02 prop_rail_signals03
        prop_rail_signals04 prop_sign_airp_01a prop_sign_airp_02a prop_sign_airp_02b prop_sign_interstate_01 prop_sign_interstate_02
        prop_sign_interstate_03 prop_sign_interstate_04 prop_sign_interstate_05 prop_sign_loading_1 prop_sign_parking_1 prop_sign_road_01c
        prop_sign_road_03g prop_sign_road_03h prop_sign_road_03i prop_sign_road_03j prop_sign_road_03k prop_sign_road_03l prop_sign_road_03n
        prop_sign_road_03o prop_sign_road_03p prop_sign_road_03q prop_sign_road_03r prop_sign_road_03s prop_sign_road_03t prop_sign_road_03u
        prop_sign_road_03v prop_sign_road_03x prop_sign_road_03z prop_sign_road_04b prop_sign_road_04c prop_sign_road_04d prop_sign_road_04e
        prop_sign_road_04f prop_sign_road_04g prop_sign_road_04g_l1 prop_sign_road_04h prop_sign_road_04i prop_sign_road_04j
        prop_sign_road_04k prop_sign_road_04l prop_sign_road_04m prop_sign_road_04n prop_sign_road_04o prop_sign_road_04p prop_sign_road_04q
        prop_sign_road_04r prop_sign_road_04s prop_sign_road_04t prop_sign_road_04u prop_sign_road_04v prop_sign_road_04x prop_sign_road_04y
        prop_sign_road_04z prop_sign_road_05b prop_sign_road_05c prop_sign_road_05d prop_sign_road_05g prop_sign_road_05h prop_sign_road_05i
        prop_sign_road_05j prop_sign_road_05k prop_sign_road_05l prop_sign_road_05m prop_sign_road_05n prop_sign_road_05o prop_sign_road_05p
        prop_sign_road_05q prop_sign_road_05r prop_sign_road_05s prop_sign_road_05t prop_sign_road_05u prop_sign_road_05v prop_sign_road_05w
        prop_sign_road_05x prop_sign_road_05y prop_sign_road_05z prop_sign_road_05za prop_sign_road_06h prop_sign_road_06l
        prop_sign_road_07a prop_sign_road_07b prop_sign_road_08a prop_sign_road_08b prop_sign_road_09a prop_sign_road_09b prop_sign_road_09c
        prop_sign_road_09d prop_sign_road_09e prop_sign_road_09f prop_sign_taxi_1 prop_snow_rail_signals02 prop_trafficdiv_01
        prop_trafficdiv_02
        """;

    private static readonly char[] Blanks = [' ', ',', '\r', '\n'];

    private static readonly Dictionary<int, string> Unnamed = Split(UnnamedModels).ToDictionary(ModelHash.Of);

    /// <summary>The name of a model whose sign is unnamed, by its hash; null for any other.</summary>
    public static string? UnnamedBy(int hash) => Unnamed.TryGetValue(hash, out string? name) ? name : null;

    /// <summary>
    /// The models to measure: those of a table with what it contains about their signs, then the unnamed ones and further ones that it
    /// lacks.
    /// </summary>
    /// <param name="table">The known faces. Models without a name are left out: the survey requests models by name.</param>
    /// <param name="further">Names of further models, separated by commas or blanks.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public static IReadOnlyList<SurveyedModel> ToMeasure(FaceTable table, string further)
    {
        if (table is null)
        {
            throw new ArgumentNullException(nameof(table));
        }

        if (further is null)
        {
            throw new ArgumentNullException(nameof(further));
        }

        IEnumerable<SurveyedModel> known = table
            .Faces.Where(face => face.Model.Length > 0)
            .GroupBy(face => face.Model)
            .Select(faces => (First: faces.First(), All: faces.ToArray()))
            .Select(faces => new SurveyedModel(faces.First.Model, faces.First.Class, faces.First.Name, faces.First.MutcdCode)
            {
                Known = faces.All,
            });
        IEnumerable<SurveyedModel> unnamed = Split(UnnamedModels)
            .Concat(Split(further.ToLowerInvariant()))
            .Distinct()
            .Where(model => table.Of(model).Count == 0)
            .Select(model => new SurveyedModel(model, ObjectClass.Sign, string.Empty, string.Empty));
        return [.. known, .. unnamed];
    }

    private static string[] Split(string models) => models.Split(Blanks, StringSplitOptions.RemoveEmptyEntries);
}
