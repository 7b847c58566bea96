import com.eteks.sweethome3d.io.DefaultFurnitureCatalog;
import com.eteks.sweethome3d.io.HomeFileRecorder;
import com.eteks.sweethome3d.model.*;
import java.io.File;
import java.io.PrintWriter;
import java.util.*;

/** Writes the homes of this folder, and the areas of their rooms as the application has them. */
public class Homes {
    static final Map<String, PieceOfFurniture> CATALOG = new HashMap<>();
    static PrintWriter areas;
    static String folder;

    final String name;
    final Home home;
    Level level;

    Homes(String name) {
        this.name = name;
        home = new Home(250);
    }

    Homes level(String title, float elevation) {
        level = new Level(title, elevation, 12, 250);
        home.addLevel(level);
        return this;
    }

    /** Walls from point to point, each joined to the next; closed if the last point is the first. */
    List<Wall> walls(float thickness, float... points) {
        List<Wall> walls = new ArrayList<>();
        for (int i = 0; i + 3 < points.length; i += 2) {
            Wall wall = new Wall(points[i], points[i + 1], points[i + 2], points[i + 3], thickness, 250);
            home.addWall(wall);
            wall.setLevel(level);
            if (i > 0) join(walls.get(walls.size() - 1), wall);
            walls.add(wall);
        }
        int n = points.length;
        if (points[0] == points[n - 2] && points[1] == points[n - 1]) join(walls.get(walls.size() - 1), walls.get(0));
        return walls;
    }

    static void join(Wall from, Wall to) {
        from.setWallAtEnd(to);
        to.setWallAtStart(from);
    }

    Room room(String title, float... points) {
        float[][] corners = new float[points.length / 2][];
        for (int i = 0; i < corners.length; i++) corners[i] = new float[] {points[2 * i], points[2 * i + 1]};
        Room room = new Room(corners);
        room.setName(title);
        home.addRoom(room);
        room.setLevel(level);
        areas.println(name + "\t" + (level == null ? "-" : level.getName()) + "\t" + (title == null ? "-" : title) + "\t" + room.getArea() / 10000);
        return room;
    }

    Room box(String title, float x0, float y0, float x1, float y1) {
        return room(title, x0, y0, x1, y0, x1, y1, x0, y1);
    }

    HomePieceOfFurniture put(String id, float x, float y, double degrees) {
        PieceOfFurniture from = CATALOG.get("eTeks#" + id);
        HomePieceOfFurniture piece = from instanceof DoorOrWindow ? new HomeDoorOrWindow((DoorOrWindow) from)
            : from instanceof com.eteks.sweethome3d.model.Light ? new HomeLight((com.eteks.sweethome3d.model.Light) from)
            : new HomePieceOfFurniture(from);
        piece.setX(x);
        piece.setY(y);
        piece.setAngle((float) Math.toRadians(degrees));
        home.addPieceOfFurniture(piece);
        piece.setLevel(level);
        return piece;
    }

    HomePieceOfFurniture mirrored(String id, float x, float y, double degrees) {
        HomePieceOfFurniture piece = put(id, x, y, degrees);
        piece.setModelMirrored(true);
        return piece;
    }

    void group(String title, HomePieceOfFurniture... pieces) {
        for (HomePieceOfFurniture piece : pieces) home.deletePieceOfFurniture(piece);
        HomeFurnitureGroup group = new HomeFurnitureGroup(Arrays.asList(pieces), title);
        home.addPieceOfFurniture(group);
        group.setLevel(level);
    }

    void save() throws Exception {
        String file = folder + "/" + name + ".sh3d";
        (name.equals("before_5_3") ? new HomeFileRecorder() : new HomeFileRecorder(0, false, null, false, true)).writeHome(home, file);
    }

    /** A flat of five rooms with the furniture of its kitchen and bath. */
    static Homes flat(String name) {
        Homes flat = new Homes(name).level("Ground floor", 0);
        flat.walls(20, 0, 0, 900, 0, 900, 700, 0, 700, 0, 0);
        flat.walls(10, 0, 350, 900, 350);
        flat.walls(10, 500, 0, 500, 350);
        flat.walls(10, 300, 350, 300, 700);
        flat.walls(10, 600, 350, 600, 700);
        flat.box("Living room", 10, 10, 495, 345);
        flat.box("Kitchen", 505, 10, 890, 345);
        flat.box("Bedroom 1", 10, 355, 295, 690);
        flat.box("Entrance hall", 305, 355, 595, 690);
        flat.box("Bathroom", 605, 355, 890, 690);
        flat.put("frontDoor", 450, 700, 180);
        flat.put("door", 400, 350, 0);
        flat.mirrored("door", 560, 350, 180);
        flat.put("door", 300, 500, 90);
        flat.mirrored("door", 600, 620, 270);
        flat.put("doorFrame", 500, 250, 90);
        flat.put("doubleFrenchWindow126x200", 250, 0, 0);
        flat.put("doubleWindow126x123", 700, 0, 0);
        flat.put("window85x163", 0, 520, 270);
        flat.put("window85x123", 900, 520, 90);
        flat.put("kitchenCabinet", 540, 42, 0);
        flat.put("sink", 630, 42, 0);
        flat.put("cooker", 720, 42, 0);
        flat.put("fridge", 860, 43, 0);
        flat.put("kitchenUpperCabinet", 540, 30, 0).setElevation(145);
        flat.put("bath", 810, 393, 0);
        flat.put("toiletUnit", 850, 600, 90);
        flat.put("washbasinWithCabinet", 720, 662, 180);
        flat.put("bed90x190", 125, 580, 180);
        flat.put("wardrobe", 80, 382, 0);
        flat.put("sofa", 100, 300, 180);
        flat.put("tvUnit", 100, 36, 0);
        flat.put("mannequin", 450, 600, 0);
        return flat;
    }

    static Homes storeys() {
        Homes house = new Homes("storeys").level("Erdgeschoss", 0);
        Level ground = house.level;
        for (int i = 0; i < 2; i++) {
            if (i > 0) house.level("Obergeschoss", 262);
            house.walls(30, 0, 0, 800, 0, 800, 600, 0, 600, 0, 0);
            house.walls(12, 400, 0, 400, 600);
            house.box(i == 0 ? "Wohnzimmer" : "Schlafzimmer", 15, 15, 394, 585);
            house.box(i == 0 ? "Küche" : null, 406, 15, 785, 585);
            house.put("door", 400, 450, 90);
            house.put("doubleWindow126x163", 200, 0, 0);
            house.put("doubleWindow126x163", 600, 600, 180);
        }
        house.put("toiletUnit", 700, 100, 90);
        house.put("shower", 745, 545, 180);
        house.level = ground;
        house.put("frontDoor", 100, 600, 180);
        house.put("staircase", 52, 130, 0);
        house.level("Garten", 0);
        house.level.setElevationIndex(1);
        return house;
    }

    static Homes round() {
        Homes tower = new Homes("round").level("Tower", 0);
        List<Wall> walls = tower.walls(20, 0, 0, 600, 0, 600, 500, 0, 500, 0, 0);
        walls.get(1).setArcExtent((float) Math.PI / 2);
        walls.get(3).setArcExtent((float) Math.PI);
        // Both faces of each wall, of which the inner one is the second half: as the tool for rooms finds it.
        List<Float> corners = new ArrayList<>();
        for (Wall wall : walls) {
            float[][] points = wall.getPoints();
            for (int i = points.length - 1; i > points.length / 2; i--) {
                corners.add(points[i][0]);
                corners.add(points[i][1]);
            }
        }
        float[] flat = new float[corners.size()];
        for (int i = 0; i < flat.length; i++) flat[i] = corners.get(i);
        tower.room("Living room", flat);
        float x = walls.get(3).getXArcCircleCenter() - 250, y = walls.get(3).getYArcCircleCenter();
        tower.put("frontDoor", x, y, 270);
        double reach = Math.hypot(250, 250);
        tower.put("doubleWindow126x163", walls.get(1).getXArcCircleCenter() + (float) reach, walls.get(1).getYArcCircleCenter(), 90);
        tower.put("window85x123", 300, 0, 0);
        return tower;
    }

    static Homes withoutRooms() {
        Homes home = new Homes("without_rooms").level("Level 0", 0);
        home.walls(20, 0, 0, 800, 0, 900, 600, 0, 600, 0, 0);
        home.walls(10, 400, 0, 400, 600);
        home.walls(10, 400, 300, 850, 300);
        home.walls(10, 100, 200, 200, 200, 200, 300, 100, 300, 100, 200);
        home.walls(10, 0, 450, 150, 450);
        home.put("frontDoor", 250, 600, 180);
        home.put("door", 400, 450, 90);
        home.put("door", 600, 300, 0);
        home.put("doubleWindow126x163", 600, 0, 0);
        home.put("bed140x190", 520, 140, 0);
        home.put("fittedBath", 520, 345, 0);
        home.put("toiletUnit", 600, 540, 180);
        return home;
    }

    static Homes attic() {
        Homes home = new Homes("attic").level("Attic", 0);
        List<Wall> walls = home.walls(20, 0, 0, 600, 0, 600, 400, 0, 400, 0, 0);
        walls.get(0).setHeightAtEnd(120f);
        walls.get(1).setHeight(120f);
        walls.get(2).setHeight(120f);
        walls.get(2).setHeightAtEnd(250f);
        home.box("Study", 10, 10, 590, 390);
        home.put("door", 0, 200, 270);
        return home;
    }

    static Homes centreLines() {
        Homes home = new Homes("centre_lines").level("Level 0", 0);
        home.walls(24, 0, 0, 800, 0, 800, 400, 0, 400, 0, 0);
        home.walls(12, 400, 0, 400, 400);
        home.box("Bedroom", 0, 0, 400, 400);
        home.box("Office", 400, 0, 800, 400);
        home.put("door", 400, 200, 90);
        home.put("frontDoor", 600, 400, 180);
        return home;
    }

    static Homes groups() {
        Homes home = new Homes("groups");
        home.walls(15, 0, 0, 500, 0, 500, 400, 0, 400, 0, 0);
        home.walls(15, 200, 200, 200, 320);
        home.box("Chambre", 7.5f, 7.5f, 492.5f, 392.5f);
        home.group("Way in", home.put("door", 400, 400, 180), home.put("window85x123", 300, 400, 180));
        home.group("Bed", home.put("bed140x190", 120, 115, 0), home.put("bedsideTable", 220, 40, 0), home.put("floorUplight", 30, 370, 0));
        HomePieceOfFurniture hidden = home.put("door", 100, 400, 180);
        hidden.setVisible(false);
        return home;
    }

    /** Every door of the catalogue, turned and mirrored, each in a wall of its own between two rooms. */
    static Homes doors() {
        Homes home = new Homes("doors").level("Doors", 0);
        String[] ids = {"door", "frontDoor", "roundedDoor", "openDoor", "frenchWindow85x200", "doubleFrenchWindow126x200", "doorFrame", "garageDoor", "sliderWindow126x200"};
        for (int i = 0; i < ids.length; i++) {
            for (int j = 0; j < 8; j++) {
                float x = 800 * i, y = 600 * j;
                boolean upright = j % 2 == 1;
                home.walls(20, x, y, x + 600, y, x + 600, y + 400, x, y + 400, x, y);
                if (upright) {
                    home.walls(10, x + 300, y, x + 300, y + 400);
                    home.box("Room a" + i + j, x + 10, y + 10, x + 295, y + 390);
                    home.box("Room b" + i + j, x + 305, y + 10, x + 590, y + 390);
                } else {
                    home.walls(10, x, y + 200, x + 600, y + 200);
                    home.box("Room a" + i + j, x + 10, y + 10, x + 590, y + 195);
                    home.box("Room b" + i + j, x + 10, y + 205, x + 590, y + 390);
                }
                HomePieceOfFurniture piece = home.put(ids[i], x + 300, y + 200, 90 * (j % 4));
                piece.setModelMirrored(j >= 4);
            }
        }
        return home;
    }

    /** Two levels of twenty rooms along a corridor each. */
    static Homes forty() {
        Homes home = new Homes("forty_rooms");
        for (int storey = 0; storey < 2; storey++) {
            home.level("Level " + storey, storey * 262);
            home.walls(20, 0, 0, 4000, 0, 4000, 1200, 0, 1200, 0, 0);
            home.walls(10, 0, 500, 4000, 500);
            home.walls(10, 0, 700, 4000, 700);
            home.box("Corridor", 10, 505, 3990, 695);
            home.put("frontDoor", 0, 600, 270);
            for (int i = 0; i < 10; i++) {
                for (int side = 0; side < 2; side++) {
                    float low = side == 0 ? 10 : 705, high = side == 0 ? 495 : 1190;
                    if (i > 0) home.walls(10, 400 * i, low - 5, 400 * i, high + 5);
                    if (i == 9 && side == 1) continue;
                    home.box("Bedroom " + i + side, i == 0 ? 10 : 400 * i + 5, low, i == 9 ? 3990 : 400 * i + 395, high);
                    home.put("door", 400 * i + 200, side == 0 ? 500 : 700, side == 0 ? 180 : 0);
                    home.put("doubleWindow126x163", 400 * i + 200, side == 0 ? 0 : 1200, side == 0 ? 0 : 180);
                    home.put("bed140x190", 400 * i + 120, side == 0 ? 115 : 1085, side == 0 ? 0 : 180);
                    home.put("wardrobe", 400 * i + 300, side == 0 ? 40 : 1160, side == 0 ? 0 : 180);
                }
            }
        }
        return home;
    }

    public static void main(String[] arguments) throws Exception {
        folder = arguments[0];
        areas = new PrintWriter(new File(folder, "areas.tsv"), "UTF-8");
        for (FurnitureCategory category : new DefaultFurnitureCatalog((UserPreferences) null, (File[]) null).getCategories())
            for (CatalogPieceOfFurniture piece : category.getFurniture()) CATALOG.put(piece.getId(), piece);
        Homes old = new Homes("before_5_3");
        old.walls(20, 0, 0, 400, 0, 400, 300, 0, 300, 0, 0);
        for (Homes home : new Homes[] {flat("flat"), storeys(), round(), withoutRooms(), attic(), centreLines(), groups(), doors(), forty(), old}) home.save();
        areas.close();
    }
}
